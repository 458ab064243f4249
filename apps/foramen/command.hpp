#pragma once
/// \file
/// What the sub-commands of the program share.

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "foramen/core/run_context.hpp"

namespace foramen::app {

/// Exit codes, a fixed contract.
enum ExitCode { done = 0, refused = 1, usage = 2, not_converged = 3, cancelled = 130 };

/// How a command talks to its user. Results go to stdout, everything else to stderr.
struct Console {
  bool json = false;   ///< one object on stdout instead of text
  bool quiet = false;  ///< no progress, no summary
  int threads = 0;
  std::string command;  ///< canonical: without -o, --threads, --json, --quiet, inputs by their base names

  /// A context whose progress is shown as a bar on a terminal and as plain lines otherwise, and which Ctrl-C
  /// stops.
  RunContext context() const;
  /// A line for the user unless quiet or json.
  void say(const std::string& line) const;
  /// A warning: always shown unless quiet.
  void warn(const std::string& line) const;
};

/// Adds --threads, --json, --quiet.
void add_console_options(CLI::App& command, Console& console);

/// Each registers one sub-command whose work is left in `run`.
using Run = std::function<int()>;
void add_build(CLI::App& program, Run& run);
void add_compare(CLI::App& program, Run& run);
void add_demo(CLI::App& program, Run& run);
void add_evaluate(CLI::App& program, Run& run);
void add_inspect(CLI::App& program, Run& run);
void add_modes(CLI::App& program, Run& run);
void add_render(CLI::App& program, Run& run);
void add_report(CLI::App& program, Run& run);
void add_sample(CLI::App& program, Run& run);
void add_synth(CLI::App& program, Run& run);

}  // namespace foramen::app
