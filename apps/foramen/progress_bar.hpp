#pragma once
/// \file
/// The progress of a run, shown on a terminal.

#include <chrono>
#include <optional>
#include <set>
#include <string>

#include "foramen/core/run_context.hpp"

namespace foramen::app {

/// The remaining seconds of a stage, if it continues at its average speed so far. Unset at the beginning of a
/// stage, when the estimate would be poor.
std::optional<double> remaining_seconds(double elapsed_seconds, double fraction);

/// On a terminal, redraws one line with the stage, a bar, the item just finished and the remaining time.
/// Elsewhere, prints the name of each stage once, when it begins.
class ProgressBar {
 public:
  explicit ProgressBar(bool terminal) : terminal_(terminal) {}
  ~ProgressBar() { leave_line(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// \param stage_seconds  seconds since the stage began
  void show(const Progress& progress, double stage_seconds);
  /// Ends the line of the bar, so that the next output has a line of its own.
  void leave_line();

 private:
  bool terminal_;
  bool in_line_ = false;
  std::string stage_;
  std::set<std::string> told_;  // stages whose names were printed
};

}  // namespace foramen::app
