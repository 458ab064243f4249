#pragma once
/// \file
/// What a run does as it does it, for other programs (events) and for later (a log file).

#include <chrono>
#include <fstream>
#include <mutex>
#include <string>

#include "foramen/core/run_context.hpp"

namespace foramen::app {

/// Where to; both empty: nowhere.
struct RecordOptions {
  std::string events;  ///< a file, or - for standard error: one JSON object a line
  std::string log;     ///< a file of text, a time before each line; what is there already stays
};

/// Events: {"event": "started", "command", "version", "time"}, {"event": "progress", "seconds", "stage",
/// "fraction", "item", "remaining_seconds" or null}, {"event": "warning" or "message", "seconds", "text"},
/// {"event": "ended", "seconds", "exit_code", "error" or null}. Every line is written at once. Safe to use
/// from many threads.
class RunRecord {
 public:
  /// Throws IoError if a file cannot be written.
  RunRecord(const RecordOptions& options, const std::string& command);
  void progress(const Progress& progress, double stage_seconds);
  void warning(const std::string& text);
  void message(const std::string& text);
  /// \param error  empty: none
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
