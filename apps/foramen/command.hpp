#pragma once
/// \file
/// Declarations that the sub-commands of the program share.

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <map>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "foramen/core/remedy.hpp"
#include "foramen/core/run_context.hpp"
#include "run_journal.hpp"

namespace foramen::app {

/// Exit codes. Their values are part of the interface and never change.
enum ExitCode { done = 0, refused = 1, usage = 2, not_converged = 3, cancelled = 130 };

/// The output of a command to its user. Results go to stdout, everything else to stderr.
struct Console {
  bool json = false;   ///< one object on stdout instead of text
  bool quiet = false;  ///< no progress, no summary
  int threads = 0;
  JournalOptions journal;
  std::string command;  ///< canonical: without -o, --threads, --json, --quiet, --events, --log, inputs by
                        ///< their base names

  /// A context whose progress is shown as a bar on a terminal and as plain lines otherwise, and which Ctrl-C
  /// stops.
  RunContext context() const;
  /// Prints a line, unless quiet or json is set.
  void say(const std::string& line) const;
  /// Prints a warning, unless quiet is set.
  void warn(const std::string& line) const;
  /// The same with the flags for its remedies.
  void warn(const Message& message) const;
};

/// Adds an option whose value is one of these words, in upper or lower case. The option keeps the word, so
/// that the recorded command has the form in which a user types it. A CLI11 transformer would keep the number
/// of the value instead.
template <class Value>
CLI::Option* add_choice(CLI::App& command, const std::string& option, Value& value,
                        const std::map<std::string, Value>& choices, const std::string& what) {
  std::vector<std::string> words;
  words.reserve(choices.size());
  std::string chosen;
  for (const auto& [word, meaning] : choices) {
    words.push_back(word);
    if (meaning == value) chosen = word;
  }
  const auto take = [&value, choices](const std::string& word) { value = choices.at(word); };
  return command.add_option_function<std::string>(option, take, what)
      ->transform(CLI::IsMember(words, CLI::ignore_case))
      ->default_str(chosen);
}

/// Says how many meshes were written to a folder, as text or as JSON.
void tell_written(const Console& console, const std::filesystem::path& folder, int files);

/// Adds --threads, --json, --quiet, --events, --log.
void add_console_options(CLI::App& command, Console& console);

/// The command in the form in which it is recorded: everything that determines the result, and nothing else.
/// Files are given by their base names.
std::string canonical_command(const CLI::App& command, const std::vector<std::string>& inputs);

/// Begins the journal (--events and --log) with the command as it was typed.
void begin_run(const std::string& command);
/// Ends the journal (--events and --log). \param error  empty if there is none
void end_run(int exit_code, const std::string& error = {});

/// Each function below registers one sub-command. When the sub-command is parsed, it sets `run` to its work.
using Run = std::function<int()>;
void add_build(CLI::App& program, Run& run);
void add_compare(CLI::App& program, Run& run);
void add_complete(CLI::App& program, Run& run);
void add_completion(CLI::App& program, Run& run);
void add_convert(CLI::App& program, Run& run);
void add_demo(CLI::App& program, Run& run);
void add_evaluate(CLI::App& program, Run& run);
void add_extract(CLI::App& program, Run& run);
void add_inspect(CLI::App& program, Run& run);
void add_manual(CLI::App& program, Run& run);
void add_measure(CLI::App& program, Run& run);
void add_modes(CLI::App& program, Run& run);
void add_project(CLI::App& program, Run& run);
void add_reconstruct(CLI::App& program, Run& run);
void add_render(CLI::App& program, Run& run);
void add_repair(CLI::App& program, Run& run);
void add_report(CLI::App& program, Run& run);
void add_sample(CLI::App& program, Run& run);
void add_synth(CLI::App& program, Run& run);

}  // namespace foramen::app
