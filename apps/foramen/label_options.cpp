#include "label_options.hpp"

#include <algorithm>

#include "described_option.hpp"
#include "foramen/core/error.hpp"

namespace foramen::app {

void LabelFlags::add_to(CLI::App& command) {
  CLI::Option* numbering = add_choice<LabelNumbering>(
      command, "--numbering", numbering_,
      {{"verse", LabelNumbering::verse}, {"totalsegmentator", LabelNumbering::totalsegmentator}},
      "what the labels of label maps stand for");
  options_ = {
      command.add_option("--labels", labels_,
                         "labels to take from label maps, e.g. 20-24,3; otherwise all that have a name"),
      numbering,
      command
          .add_option("--label-names", names_file_,
                      "CSV file with the columns label and name: what the labels stand for")
          ->excludes(numbering),
      add_described(command, "--keep-cut", surface_, "keep_cut")};
}

std::optional<LabelRequest> LabelFlags::resolved() const {
  if (std::all_of(options_.begin(), options_.end(), [](const CLI::Option* o) { return o->count() == 0; }))
    return std::nullopt;
  LabelRequest request;
  request.names = names_file_.empty() ? label_names(numbering_) : read_label_names(names_file_);
  request.surface = surface_;
  if (options_.front()->count() > 0) {
    try {
      request.labels = LabelSelection::parse(labels_);
    } catch (const InvalidInput& e) {
      throw CLI::ValidationError("--labels", e.what());
    }
  }
  return request;
}

}  // namespace foramen::app
