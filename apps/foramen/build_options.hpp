#pragma once
/// \file
/// The options of a build, which `build` and `demo` share.

#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "command.hpp"
#include "label_options.hpp"
#include "repair_options.hpp"
#include "workflow/build_choices.hpp"
#include "workflow/run_build.hpp"

namespace foramen::app {

/// The flags for the choices of a build.
struct BuildFlags {
  BuildChoices choices;

  void add_to(CLI::App& command);
  /// Throws CLI::ValidationError for a flag that would have no effect. \pre the command line is parsed
  BuildOptions resolved() const;
};

/// Everything except the inputs that determines the result of a build.
struct BuildArguments {
  BuildFlags flags;
  LabelFlags label_flags;
  std::string truth, store;
  InputUnit unit;
  bool refit = false, resume = false, repair = false;
  RepairOptions repair_options;

  void add_to(CLI::App& command);
  /// Throws as BuildFlags::resolved() and LabelFlags::resolved(). \pre the command line is parsed
  BuildRequest request(const std::vector<std::string>& inputs, const std::string& output,
                       const std::string& canonical_command) const;
};

/// Prints what a build says and returns the exit code.
int print_build(const BuildSummary& summary, const Console& console, bool strict);

}  // namespace foramen::app
