#pragma once
/// \file
/// The record of a build that has just been made.

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "foramen/evaluate/evaluate.hpp"
#include "modelfiles/build_record.hpp"
#include "modelfiles/run_file.hpp"

namespace foramen {

/// What was asked for.
struct RunDescription {
  std::string command;  ///< canonical
  BuildOptions build;
  LabelRequest labels;  ///< of the label maps among the inputs
};

/// How a run went: differs from run to run, whatever the result.
struct RunFigures {
  double seconds = 0;
  int threads = 0;
  int stages_taken_up = 0;  ///< done by an interrupted build before
};

/// The record of a run: version, command, options, inputs, what became of each shape, times, memory.
RunRecord describe_run(const RunDescription& asked, const BuildRecord& record, const Evaluation& evaluation,
                       const RunFigures& figures);

/// A build's options by their command-line names.
nlohmann::ordered_json options_json(const BuildOptions& options);

}  // namespace foramen
