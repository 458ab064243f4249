#pragma once
/// \file
/// Which labels of label maps a user wants, and what they stand for.

#include <optional>

#include "extract/label_names.hpp"
#include "extract/label_selection.hpp"
#include "foramen/extract/extract_label.hpp"

namespace foramen {

struct LabelRequest {
  std::optional<LabelSelection> labels = std::nullopt;  ///< Unset: all labels that have a name.
  /// Unset: the names in the file or in its file name, and VerSe's numbering where there are none.
  std::optional<LabelNumbering> numbering = std::nullopt;
  std::optional<LabelNames> names = std::nullopt;  ///< The user's own names, before all others.
  ExtractOptions surface = {};
};

}  // namespace foramen
