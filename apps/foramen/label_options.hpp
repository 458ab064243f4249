#pragma once
/// \file
/// The options for label maps, which `extract` and `build` share.

#include <optional>
#include <string>
#include <vector>

#include "command.hpp"
#include "workflow/label_choices.hpp"

namespace foramen::app {

class LabelFlags {
 public:
  void add_to(CLI::App& command);
  /// The request; unset if no flag was given. Throws CLI::ValidationError for text that is no list of labels,
  /// and IoError if the file of names cannot be read. \pre the command line is parsed
  std::optional<LabelRequest> resolved() const;

 private:
  LabelChoices choices_;
};

}  // namespace foramen::app
