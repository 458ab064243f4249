#include <unistd.h>

#include <chrono>
#include <csignal>
#include <iostream>
#include <memory>
#include <optional>

#include <nlohmann/json.hpp>

#include "command.hpp"
#include "progress_bar.hpp"
#include "remedy_words.hpp"

namespace foramen::app {
namespace {

// The context that Ctrl-C stops. It is set once, before the signal handler is installed.
std::optional<RunContext> interruptible;

extern "C" void on_interrupt(int) { interruptible->request_stop(); }

// A second Ctrl-C ends the program at once, as if there were no handler.
void stop_on(int signal) {
  struct sigaction action {};
  action.sa_handler = on_interrupt;
  action.sa_flags = SA_RESETHAND | SA_RESTART;
  sigaction(signal, &action, nullptr);
}

// Reports the progress of a run to the terminal and to the files of --events and --log.
class Reporter {
 public:
  Reporter(const Console& console, const std::string& command_line)
      : journal_(console.journal, command_line) {
    if (!console.quiet && !console.json && console.journal.events != "-")
      bar_.emplace(isatty(STDERR_FILENO) != 0);
  }
  void progress(const Progress& progress) {
    if (progress.stage != stage_) stage_start_ = std::chrono::steady_clock::now();
    stage_ = progress.stage;
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - stage_start_).count();
    journal_.progress(progress, seconds);
    if (bar_) bar_->show(progress, seconds);
  }
  RunJournal& journal() { return journal_; }
  // Ends the line of the progress bar, so that the next output begins on a new line.
  void leave_bar() {
    if (bar_) bar_->leave_line();
  }

 private:
  RunJournal journal_;
  std::optional<ProgressBar> bar_;
  std::string stage_;
  std::chrono::steady_clock::time_point stage_start_;
};

std::string command_line;            // the command as it was typed
std::shared_ptr<Reporter> reporter;  // this program has only one run

Reporter& reporter_of(const Console& console) {
  if (!reporter) reporter = std::make_shared<Reporter>(console, command_line);
  return *reporter;
}

}  // namespace

void begin_run(const std::string& command) { command_line = command; }

void end_run(int exit_code, const std::string& error) {
  if (!reporter) return;
  reporter->leave_bar();
  reporter->journal().ended(exit_code, error);
}

RunContext Console::context() const {
  if (interruptible) return *interruptible;
  reporter_of(*this);
  interruptible = RunContext(threads, [](const Progress& p) { reporter->progress(p); });
  stop_on(SIGINT);
  stop_on(SIGTERM);
  return *interruptible;
}

void Console::say(const std::string& line) const {
  reporter_of(*this).leave_bar();
  reporter_of(*this).journal().message(line);
  if (!quiet && !json) std::cout << line << '\n';
}

void Console::warn(const std::string& line) const {
  reporter_of(*this).leave_bar();
  reporter_of(*this).journal().warning(line);
  if (!quiet && journal.events != "-") std::cerr << "warning: " << line << '\n';
}

void Console::warn(const Message& message) const { warn(worded(message)); }

void tell_written(const Console& console, const std::filesystem::path& folder, int files) {
  if (console.json)
    std::cout << nlohmann::ordered_json{{"folder", folder.string()}, {"files", files}}.dump(2) << '\n';
  else
    console.say("wrote " + std::to_string(files) + " meshes to " + folder.string());
}

void add_console_options(CLI::App& command, Console& console) {
  command.add_option("--threads", console.threads, "threads to use (0: all)")->check(CLI::Range(0, 1024));
  command.add_flag("--json", console.json, "print one JSON object on standard output");
  command.add_flag("--quiet", console.quiet, "print nothing but errors");
  command.add_option(
      "--events", console.journal.events,
      "file for progress, warnings and the end as they come, one JSON object a line; -: standard error");
  command.add_option("--log", console.journal.log, "file to append the same to, as text with times");
}

}  // namespace foramen::app
