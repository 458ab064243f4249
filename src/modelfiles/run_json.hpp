#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "foramen/evaluate/evaluate.hpp"
#include "modelfiles/build_record.hpp"

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
nlohmann::ordered_json run_json(const RunDescription& asked, const BuildRecord& record,
                                const Evaluation& evaluation, const RunFigures& figures);

/// A build's options by their command-line names.
nlohmann::ordered_json options_json(const BuildOptions& options);

/// How a label became a surface.
nlohmann::ordered_json extraction_json(const ExtractionReport& report);
/// Options for label maps by their command-line names.
nlohmann::ordered_json label_options_json(const LabelRequest& request);

/// Largest resident memory of this process so far, MB.
double peak_memory_mb();

}  // namespace foramen
