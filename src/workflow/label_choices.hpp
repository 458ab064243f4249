#pragma once
/// \file
/// The options by which a user selects labels of label maps.

#include <optional>
#include <string>

#include "extract/extract_labels.hpp"
#include "foramen/core/options.hpp"

namespace foramen {

struct LabelChoices {
  std::optional<LabelNumbering> numbering = std::nullopt;  ///< unset: see LabelRequest
  std::optional<std::string> labels = std::nullopt;        ///< see LabelSelection::parse()
  std::optional<std::string> names_file = std::nullopt;    ///< see read_label_names()
  bool keep_cut = false;
};
template <class Visitor>
void describe(Visitor& visit, MaybeConst<LabelChoices> auto& c) {
  visit(c.numbering, {.name = "numbering", .meaning = "what the labels of label maps stand for"});
  visit(c.labels,
        {.name = "labels",
         .meaning = "labels to take from label maps, e.g. 20-24,3; otherwise all that have a name"});
  visit(c.names_file, {.name = "label_names",
                       .meaning = "CSV file with the columns label and name: what the labels stand for"});
  visit(c.keep_cut,
        {.name = "keep_cut",
         .meaning = "also take labels that reach the border of the label map, closed flat there"});
}

/// The request for these choices; unset if no choice is set. Throws InvalidInput for text that is no list of
/// labels, and if both a numbering and a file of names are given. Throws IoError if the file of names cannot
/// be read.
std::optional<LabelRequest> label_request(const LabelChoices& choices);

}  // namespace foramen
