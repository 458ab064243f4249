#pragma once
/// \file
/// The report of a model.

#include <filesystem>
#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "foramen/evaluate/evaluate.hpp"

namespace foramen {

enum class PageKind {
  interactive,  ///< the model in motion; needs a build of foramen with the viewer (has_viewer())
  plain,        ///< the same findings as text, curves and pictures
};

struct PageOptions {
  std::optional<PageKind> kind = std::nullopt;  ///< Unset: interactive where this build has the viewer.
  std::filesystem::path baseline = {};          ///< Folder of a model to compare with; empty: none.
};

struct ModelPage {
  PageKind kind = PageKind::plain;
  std::string html;
  std::string remark;  ///< which page it is, its size, and why it is plain if it is
};

/// The contents of report.html, from the other files of a model's folder. Times and memory are not used, so
/// that the same build gives the same bytes. Throws IoError if a file is missing or broken, InvalidInput if
/// the interactive page is asked for and this build of foramen has no viewer.
ModelPage model_page(const std::filesystem::path& folder, const PageOptions& options = {});

/// What a terminal shows at the end of a build: a few lines. \param run  the contents of run.json
std::string model_summary(const nlohmann::ordered_json& run, const Evaluation& evaluation);

}  // namespace foramen
