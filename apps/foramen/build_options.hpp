#pragma once
/// \file
/// The options of a build, which `build`, `demo` and the Python package share.

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "command.hpp"
#include "foramen/workflow/run_build.hpp"
#include "label_options.hpp"
#include "repair_options.hpp"

namespace foramen::app {

/// What --objective takes.
enum class ObjectiveChoice { surface, neighbours, description };

struct BuildFlags {
  CorrespondOptions correspondence;
  PlaceLandmarksOptions landmarks;
  EvaluationOptions evaluation;  ///< its scale, weights and seed are those of all stages
  std::string subject_pattern;
  bool paper = false;
  RegisterOptions overrides;  ///< what --lambda, --initial-map and --optimiser say
  ObjectiveChoice objective = ObjectiveChoice::surface;
  CLI::Option *objective_option = nullptr, *lambda_option = nullptr, *map_option = nullptr,
              *optimiser_option = nullptr;
  std::vector<CLI::Option*> group_options;  // of no effect unless shapes are registered as a group

  void add_to(CLI::App& command);
  /// --paper sets the paper's choices; what was given by name overrides them. Throws CLI::ValidationError for
  /// an option that would have no effect. \pre the command line is parsed
  BuildOptions resolved() const;
};

/// All that decides what a build gives, beside its inputs: `build` of the program and of the Python package.
struct BuildArguments {
  BuildFlags flags;
  LabelFlags label_flags;
  std::string truth, store;
  LengthUnit unit = LengthUnit::millimetre;
  bool refit = false, resume = false, repair = false;
  RepairOptions repair_options;

  void add_to(CLI::App& command);
  /// Throws as BuildFlags::resolved() and LabelFlags::resolved(). \pre the command line is parsed
  BuildRequest request(const std::vector<std::string>& inputs, const std::string& output,
                       const std::string& canonical_command) const;
};

/// Runs the build, tells the user, gives the exit code.
int finish_build(const BuildRequest& request, const Console& console, bool strict);

}  // namespace foramen::app
