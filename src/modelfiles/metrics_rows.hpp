#pragma once
/// \file
/// metrics.csv: the values of single shapes, draws and pairs of shapes, from which the estimates of
/// metrics.json are computed.

#include <filesystem>

#include "foramen/evaluate/evaluate.hpp"

namespace foramen {

/// Writes one row per shape, draw or pair of shapes, number of modes and measure.
void write_metrics_rows(const std::filesystem::path& file, const Evaluation& evaluation);

/// Reads the generalization errors of each shape, in the order of the names, into the evaluation. Throws
/// IoError if the file has no row for one of them.
void read_shape_items(const std::filesystem::path& file, Evaluation& evaluation);

}  // namespace foramen
