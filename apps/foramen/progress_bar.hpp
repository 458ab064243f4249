#pragma once
/// \file
/// How far a run has come, for a person at a terminal.

#include <chrono>
#include <optional>
#include <string>

#include "foramen/core/run_context.hpp"

namespace foramen::app {

/// Seconds that a stage will still take if it goes on as fast as it has; unset while that is a guess.
std::optional<double> remaining_seconds(double elapsed_seconds, double fraction);

/// Redraws one line on a terminal (stage, bar, what was just finished, time left); prints a line a stage, and
/// every quarter of a long one, otherwise.
class ProgressBar {
 public:
  explicit ProgressBar(bool terminal) : terminal_(terminal) {}
  ~ProgressBar() { leave_line(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// \param stage_seconds  since the stage began
  void show(const Progress& progress, double stage_seconds);
  /// So that what is printed next has a line of its own.
  void leave_line();

 private:
  bool terminal_;
  bool in_line_ = false;
  std::string stage_;
  int last_percent_ = 0;
};

}  // namespace foramen::app
