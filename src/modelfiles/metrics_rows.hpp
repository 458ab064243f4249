#pragma once
/// \file
/// metrics.csv: the single items behind the estimates of metrics.json.

#include <filesystem>

#include "foramen/evaluate/evaluate.hpp"

namespace foramen {

/// One row per shape or draw, number of modes and measure.
void write_metrics_rows(const std::filesystem::path& file, const Evaluation& evaluation);

/// Fills the items of the generalizations, in the order of the names, from the rows about shapes. Throws
/// IoError if the file holds no row for one of them.
void read_shape_items(const std::filesystem::path& file, Evaluation& evaluation);

}  // namespace foramen
