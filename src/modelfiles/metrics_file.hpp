#pragma once
/// \file
/// metrics.json and metrics.csv: every measure with its definition, unit and standard error.

#include <filesystem>
#include <string>
#include <string_view>

#include "foramen/evaluate/evaluate.hpp"

namespace foramen {

/// The contents of metrics.json: the estimate of every measure at every number of modes, and the measures of
/// each shape.
std::string metrics_json(const Evaluation& evaluation);

/// Parses what metrics_json() wrote. The result lacks the values of single items from which the estimates
/// were computed. Throws IoError, whose message calls the text by this name.
Evaluation parse_metrics(std::string_view json, const std::string& name);

/// Writes FOLDER/metrics.json, and FOLDER/metrics.csv with the columns item, kind (shape, draw or pair),
/// modes, measure, value, unit: one row per shape, draw or pair of shapes, number of modes and measure.
/// Each file is written whole or not at all. The bytes depend only on the results of the evaluation, not on
/// its duration.
void write_metrics(const std::filesystem::path& folder, const Evaluation& evaluation);

/// Reads FOLDER/metrics.json back. Throws IoError.
Evaluation read_metrics(const std::filesystem::path& folder);

/// As read_metrics(), with the generalization errors of each shape from FOLDER/metrics.csv, in the order of
/// the names. The values of single draws are not read. Throws IoError if the two files do not belong
/// together.
Evaluation read_metrics_of_shapes(const std::filesystem::path& folder);

}  // namespace foramen
