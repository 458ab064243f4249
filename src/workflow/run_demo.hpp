#pragma once
/// \file
/// A synthetic cohort, its model and report: a build that needs no input.

#include <filesystem>
#include <string>

#include "foramen/synth/synth_cohort.hpp"
#include "workflow/run_build.hpp"

namespace foramen {

struct DemoRequest {
  std::filesystem::path output;  ///< folder to write
  SynthOptions synth = {};
  BuildOptions build = {};
  EvaluationOptions evaluation = {};
  std::string canonical_command;  ///< recorded in the files
};

struct DemoSummary {
  BuildSummary build;
  std::filesystem::path report;  ///< the page of the model
};

/// Writes what write_synth_cohort() writes, and OUTPUT/model, built from these shapes and measured by their
/// true correspondence. Throws what write_synth_cohort() and run_build() throw.
DemoSummary run_demo(const DemoRequest& request, const RunContext& ctx);

}  // namespace foramen
