#include "progress_bar.hpp"

#include <cmath>
#include <cstdio>

namespace foramen::app {
namespace {

constexpr int width = 30;
// The least progress from which the remaining time is estimated.
constexpr double enough_seconds = 2, enough_fraction = 0.05;

std::string time_left(double seconds) {
  const int whole = static_cast<int>(std::lround(seconds));
  char text[40];
  if (whole < 3600)
    std::snprintf(text, sizeof text, "%d:%02d left", whole / 60, whole % 60);
  else
    std::snprintf(text, sizeof text, "%d:%02d:%02d left", whole / 3600, whole / 60 % 60, whole % 60);
  return text;
}

}  // namespace

std::optional<double> remaining_seconds(double elapsed_seconds, double fraction) {
  if (elapsed_seconds < enough_seconds || fraction < enough_fraction || fraction > 1) return {};
  return elapsed_seconds * (1 - fraction) / fraction;
}

void ProgressBar::show(const Progress& progress, double stage_seconds) {
  const int percent = static_cast<int>(100 * progress.fraction);
  if (terminal_) {
    if (progress.stage != stage_) leave_line();
    const std::size_t filled = static_cast<std::size_t>(percent * width / 100);
    const auto left = remaining_seconds(stage_seconds, progress.fraction);
    std::fprintf(stderr, "\r\033[K%-16s [%s%s] %3d %%  %s%s%s", progress.stage.c_str(),
                 std::string(filled, '#').c_str(), std::string(width - filled, '.').c_str(), percent,
                 progress.item.c_str(), left && !progress.item.empty() ? ", " : "",
                 left ? time_left(*left).c_str() : "");
    std::fflush(stderr);
    in_line_ = true;
  } else if (told_.insert(progress.stage).second) {
    std::fprintf(stderr, "%s\n", progress.stage.c_str());
  }
  stage_ = progress.stage;
}

void ProgressBar::leave_line() {
  if (in_line_) std::fprintf(stderr, "\n");
  in_line_ = false;
}

}  // namespace foramen::app
