#pragma once
/// \file
/// What a run writes while it runs: events for other programs, and a log file for people. It is not run.json,
/// which a build writes at its end.

#include <chrono>
#include <fstream>
#include <mutex>
#include <string>

#include "foramen/core/run_context.hpp"

namespace foramen::app {

/// Where the journal is written; an empty name means nowhere.
struct JournalOptions {
  std::string events;  ///< a file, or - for standard error; one JSON object per line
  std::string log;     ///< a text file to which lines with times are appended
};

/// Events: {"event": "started", "command", "version", "time"}, {"event": "progress", "seconds", "stage",
/// "fraction", "item", "remaining_seconds" or null}, {"event": "warning" or "message", "seconds", "text"},
/// {"event": "ended", "seconds", "exit_code", "error" or null}. Every line is written immediately. The
/// functions may be called from several threads.
class RunJournal {
 public:
  /// Throws IoError if a file cannot be written.
  RunJournal(const JournalOptions& options, const std::string& command);
  void progress(const Progress& progress, double stage_seconds);
  void warning(const std::string& text);
  void message(const std::string& text);
  /// \param error  empty if there is none
  void ended(int exit_code, const std::string& error);

 private:
  void event(const std::string& line);
  void log(const std::string& line);
  double seconds() const;

  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::mutex mutex_;
  std::ofstream events_file_, log_file_;
  bool events_to_stderr_ = false;
  std::string logged_stage_;
};

}  // namespace foramen::app
