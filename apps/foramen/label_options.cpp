#include "label_options.hpp"

#include "described_option.hpp"
#include "foramen/core/error.hpp"

namespace foramen::app {

void LabelFlags::add_to(CLI::App& command) {
  LabelChoices defaults;
  defaults.numbering = LabelNumbering::verse;
  const auto added = add_choices(command, choices_, defaults);
  added.at("numbering")->default_str("the names in the file, else verse");
  added.at("label_names")->excludes(added.at("numbering"));
}

std::optional<LabelRequest> LabelFlags::resolved() const {
  try {
    return label_request(choices_);
  } catch (const InvalidInput& e) {
    throw CLI::ValidationError("--labels", e.what());
  }
}

}  // namespace foramen::app
