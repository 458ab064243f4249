#pragma once
/// \file
/// The comparison of models, as files.

#include <filesystem>
#include <string>
#include <vector>

namespace foramen {

struct ComparisonRequest {
  std::vector<std::filesystem::path> models;  ///< folders with metrics; the first is compared with the others
  std::filesystem::path output;               ///< folder to write
};

struct ComparisonSummary {
  std::string text;            ///< tables for a terminal, see ModelComparison
  std::string json;            ///< what compare.json holds
  std::filesystem::path page;  ///< compare.html
};

/// Writes compare.html, compare.json and a chart of each measure. Throws what compare_models() throws;
/// IoError.
ComparisonSummary write_comparison(const ComparisonRequest& request);

}  // namespace foramen
