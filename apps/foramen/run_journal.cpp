#include "run_journal.hpp"

#include <cstdio>
#include <ctime>

#include <nlohmann/json.hpp>

#include "foramen/core/error.hpp"
#include "modelfiles/version.hpp"
#include "progress_bar.hpp"

namespace foramen::app {
namespace {

using nlohmann::ordered_json;

std::string now() {
  const std::time_t time = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&time, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

std::ofstream open(const std::string& path, std::ios::openmode mode) {
  std::ofstream file(path, mode);
  if (!file) throw IoError(path + ": cannot be written; check the folder and its permissions");
  return file;
}

// A file name may contain bytes that are invalid in UTF-8.
std::string line_of(const ordered_json& event) {
  return event.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

}  // namespace

RunJournal::RunJournal(const JournalOptions& options, const std::string& command) {
  events_to_stderr_ = options.events == "-";
  if (!options.events.empty() && !events_to_stderr_) events_file_ = open(options.events, std::ios::trunc);
  if (!options.log.empty()) log_file_ = open(options.log, std::ios::app);
  event(line_of({{"event", "started"}, {"command", command}, {"version", version()}, {"time", now()}}));
  log("foramen " + version() + ": " + command);
}

void RunJournal::progress(const Progress& progress, double stage_seconds) {
  const auto left = remaining_seconds(stage_seconds, progress.fraction);
  ordered_json remaining;
  if (left) remaining = *left;
  event(line_of({{"event", "progress"},
                 {"seconds", seconds()},
                 {"stage", progress.stage},
                 {"fraction", progress.fraction},
                 {"item", progress.item},
                 {"remaining_seconds", remaining}}));
  const std::string stage = progress.stage;
  if (stage != logged_stage_ || !progress.item.empty())
    log(stage + (progress.item.empty() ? "" : ": " + progress.item));
  logged_stage_ = stage;
}

void RunJournal::warning(const std::string& text) {
  event(line_of({{"event", "warning"}, {"seconds", seconds()}, {"text", text}}));
  log("warning: " + text);
}

void RunJournal::message(const std::string& text) {
  event(line_of({{"event", "message"}, {"seconds", seconds()}, {"text", text}}));
  log(text);
}

void RunJournal::ended(int exit_code, const std::string& error) {
  ordered_json what;
  if (!error.empty()) what = error;
  event(line_of({{"event", "ended"}, {"seconds", seconds()}, {"exit_code", exit_code}, {"error", what}}));
  log((error.empty() ? "" : "error: " + error + "; ") + "exit code " + std::to_string(exit_code));
}

void RunJournal::event(const std::string& line) {
  const std::lock_guard lock(mutex_);
  if (events_to_stderr_) std::fprintf(stderr, "%s\n", line.c_str());
  if (events_file_.is_open()) events_file_ << line << std::endl;
}

void RunJournal::log(const std::string& line) {
  const std::lock_guard lock(mutex_);
  if (log_file_.is_open()) log_file_ << now() << ' ' << line << std::endl;
}

double RunJournal::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

}  // namespace foramen::app
