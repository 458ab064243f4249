#include "workflow/label_choices.hpp"

#include "foramen/core/error.hpp"

namespace foramen {

std::optional<LabelRequest> label_request(const LabelChoices& choices) {
  if (!choices.numbering && !choices.labels && !choices.names_file && !choices.keep_cut) return std::nullopt;
  if (choices.numbering && choices.names_file)
    throw InvalidInput("numbering has no effect beside label_names; leave one of them out");
  LabelRequest request;
  request.numbering = choices.numbering;
  if (choices.names_file) request.names = read_label_names(*choices.names_file);
  request.surface.keep_cut = choices.keep_cut;
  if (choices.labels) request.labels = LabelSelection::parse(*choices.labels);
  return request;
}

}  // namespace foramen
