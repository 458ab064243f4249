#pragma once
/// \file
/// metrics.json and metrics.csv: every measure with its definition, unit and standard error.

#include <filesystem>
#include <string>
#include <string_view>

#include "foramen/evaluate/evaluate.hpp"

namespace foramen {

/// The contents of metrics.json: estimates of every measure at every number of modes, and what is known of
/// each shape.
std::string metrics_json(const Evaluation& evaluation);

/// The way back: everything but the single items behind the estimates. Throws IoError, which calls the text
/// by this name.
Evaluation parse_metrics(std::string_view json, const std::string& name);

/// FOLDER/metrics.json, and FOLDER/metrics.csv with the columns item, kind (shape or draw), modes, measure,
/// value, unit: one row per shape or draw, number of modes and measure. Each whole or not at all. Depends on
/// nothing but the evaluation's figures (no times).
void write_metrics(const std::filesystem::path& folder, const Evaluation& evaluation);

/// Reads FOLDER/metrics.json back. Throws IoError.
Evaluation read_metrics(const std::filesystem::path& folder);

/// The same with what FOLDER/metrics.csv holds of each shape: the items of the generalizations, in the order
/// of the names. Those of draws are left out. Throws IoError if the two files do not belong together.
Evaluation read_metrics_of_shapes(const std::filesystem::path& folder);

}  // namespace foramen
