#pragma once
/// \file
/// The report of a model.

#include <filesystem>
#include <optional>
#include <string>

#include "modelfiles/model_record.hpp"

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

/// The contents of report.html. Times and memory are not used, so that the same build gives the same bytes.
/// Throws InvalidInput if the interactive page is asked for and this build of foramen has no viewer, IoError
/// if the baseline cannot be read.
ModelPage model_page(const ModelRecord& record, const PageOptions& options = {});
/// The same of the files in a model's folder. Throws IoError if one is missing or broken.
ModelPage model_page(const std::filesystem::path& folder, const PageOptions& options = {});

/// What a terminal shows at the end of a build: a few lines.
std::string model_summary(const RunRecord& run, const Evaluation& evaluation);

}  // namespace foramen
