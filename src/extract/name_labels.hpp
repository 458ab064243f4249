#pragma once
/// \file
/// What the labels of a label map stand for, and how this is known.

#include <map>
#include <string>
#include <vector>

#include "extract/label_request.hpp"
#include "foramen/core/remedy.hpp"

namespace foramen {

enum class NameSource {
  label_names,    ///< the user's own names
  numbering,      ///< the numbering that the user gave
  names_in_file,  ///< names that the label map holds
  file_name,      ///< the level in the name of a file with a single label
  assumed         ///< VerSe's numbering, because nothing else is known
};

struct LabelNaming {
  LabelNames names;
  NameSource source = NameSource::assumed;
  std::vector<Message> doubts;  ///< evidence that contradicts these names; each names both sides

  /// For records: "verse, assumed", "totalspineseg", "the names in the file" ...
  std::string origin(const LabelRequest& request) const;
};

/// Names the labels of one layer of a label map. The user's own names come first, then the numbering that the
/// user gave, then names in the file, then the level in the file's name if the layer has a single label, then
/// VerSe's numbering. Two cases differ. A single label 1, or one that the numbering does not know, is a mask,
/// which the level in the file's name tells better than a numbering. A single label 1 that nothing names is
/// called label1, because it is rarely the C1 of VerSe.
/// \param stem  the file's own name without extension
LabelNaming name_labels(const LabelMap& layer, const std::map<int, LabelExtent>& present,
                        const std::string& stem, const LabelRequest& request);

}  // namespace foramen
