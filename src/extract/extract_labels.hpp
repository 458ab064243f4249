#pragma once
/// \file
/// The surfaces of all wanted labels of one label map.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "extract/label_names.hpp"
#include "extract/label_selection.hpp"
#include "foramen/core/remedy.hpp"
#include "foramen/core/run_context.hpp"
#include "foramen/extract/extract_label.hpp"

namespace foramen {

struct LabelRequest {
  std::optional<LabelSelection> labels = std::nullopt;  ///< Unset: all labels that have a name.
  LabelNames names = label_names(LabelNumbering::verse);
  ExtractOptions surface = {};
};

struct LabelSurface {
  int label = 0;
  std::string name;  ///< e.g. "L1"
  std::string stem;  ///< file name without extension, _ and the name, e.g. "verse004_L1"
  ExtractedSurface extracted;
};

/// A wanted label for which no surface was extracted, and why.
struct RefusedLabel {
  int label = 0;
  std::string name, stem;
  Message reason;
  bool absent = false;  ///< named singly and not in the label map
};

struct LabelSurfaces {
  std::string sha256;                  ///< of the label map, see LabelMap
  std::vector<LabelSurface> surfaces;  ///< in order of label
  std::vector<RefusedLabel> refused;   ///< the same
  std::vector<Message> notes;          ///< what the user should know though it is no error
};

/// Reads the label map and extracts the surfaces of its labels in parallel. A wanted label that is absent is
/// refused if it was named singly; if it belongs to a range, a note is made. Throws IoError as
/// read_label_map() does, and InvalidInput if the map contains none of the wanted labels.
LabelSurfaces extract_labels(const std::filesystem::path& file, const LabelRequest& request,
                             const RunContext& ctx);

}  // namespace foramen
