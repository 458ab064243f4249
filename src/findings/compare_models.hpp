#pragma once
/// \file
/// Comparison of models, as in the paper's Fig. 4.

#include <filesystem>
#include <string>
#include <vector>

namespace foramen {

struct ModelComparison {
  std::string text;  ///< tables of generalization and specificity with standard errors, for a terminal; and
                     ///< what each further model is better or worse by than the first
  std::string json;  ///< the tables and differences as one JSON object
  std::string html;  ///< a page with curves and tables
  std::vector<std::pair<std::string, std::string>> charts;  ///< file name and SVG of each chart
};

/// Reads the metrics of each model's folder and compares the models. A model has the name of its folder, or
/// its path as given if two folders have the same name. Differences of generalization and representation are
/// paired if both models have shapes of the same names, and are tested by a sign-flip permutation test. The
/// draws of specificity are not paired, so its difference has the two-sample standard error. Throws IoError
/// if a folder has no metrics.
ModelComparison compare_models(const std::vector<std::filesystem::path>& models);

}  // namespace foramen
