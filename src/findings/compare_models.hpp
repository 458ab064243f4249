#pragma once
/// \file
/// Models side by side: the paper's Fig. 4.

#include <filesystem>
#include <string>
#include <vector>

namespace foramen {

struct ModelComparison {
  std::string text;  ///< tables of generalization and specificity with standard errors, for a terminal; and
                     ///< what each further model is better or worse by than the first
  std::string json;  ///< the same as one object
  std::string html;  ///< a page with curves and tables
  std::vector<std::pair<std::string, std::string>> charts;  ///< file name and SVG of each chart
};

/// Reads the metrics of each model's folder; names them by their folders, or as given where two folders have
/// one name. Differences are paired where both models have the same shapes, by name: generalization and
/// representation, with a sign-flip permutation test; specificity, whose draws are not paired, has the
/// two-sample standard error. Throws IoError if a folder has no metrics.
ModelComparison compare_models(const std::vector<std::filesystem::path>& models);

}  // namespace foramen
