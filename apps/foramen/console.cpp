#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <iostream>
#include <memory>
#include <optional>

#include "command.hpp"

namespace foramen::app {
namespace {

// The one context of the program, which Ctrl-C stops; set before the signal handler is, and never again.
std::optional<RunContext> interruptible;

extern "C" void on_interrupt(int) { interruptible->request_stop(); }

// A second Ctrl-C ends the program at once, as if there were no handler.
void stop_on(int signal) {
  struct sigaction action {};
  action.sa_handler = on_interrupt;
  action.sa_flags = SA_RESETHAND | SA_RESTART;
  sigaction(signal, &action, nullptr);
}

// Shows progress: redraws one line on a terminal, prints a line a stage (and every quarter of a long one)
// otherwise.
class ProgressPrinter {
 public:
  void show(const Progress& progress) {
    const int percent = static_cast<int>(100 * progress.fraction);
    if (terminal_) {
      if (progress.stage != stage_) std::fprintf(stderr, "%s", stage_.empty() ? "" : "\n");
      const int filled = percent * width / 100;
      std::fprintf(stderr, "\r%-12s [%s%s] %3d %%", progress.stage.c_str(), std::string(filled, '#').c_str(),
                   std::string(width - filled, '.').c_str(), percent);
      std::fflush(stderr);
    } else if (progress.stage != stage_ || percent / 25 != last_ / 25) {
      std::fprintf(stderr, "%s %d %%\n", progress.stage.c_str(), percent);
    }
    stage_ = progress.stage;
    last_ = percent;
  }
  ~ProgressPrinter() {
    if (terminal_ && !stage_.empty()) std::fprintf(stderr, "\n");
  }

 private:
  static constexpr int width = 40;
  bool terminal_ = isatty(STDERR_FILENO) != 0;
  std::string stage_;
  int last_ = 0;
};

}  // namespace

RunContext Console::context() const {
  if (interruptible) return *interruptible;
  RunContext::Callback callback;
  if (!quiet && !json) {
    auto printer = std::make_shared<ProgressPrinter>();
    callback = [printer](const Progress& p) { printer->show(p); };
  }
  interruptible = RunContext(threads, std::move(callback));
  stop_on(SIGINT);
  stop_on(SIGTERM);
  return *interruptible;
}

void Console::say(const std::string& line) const {
  if (!quiet && !json) std::cout << line << '\n';
}

void Console::warn(const std::string& line) const {
  if (!quiet) std::cerr << "warning: " << line << '\n';
}

void add_console_options(CLI::App& command, Console& console) {
  command.add_option("--threads", console.threads, "threads to use (0: all)")->check(CLI::Range(0, 1024));
  command.add_flag("--json", console.json, "print one JSON object on standard output");
  command.add_flag("--quiet", console.quiet, "print nothing but errors");
}

}  // namespace foramen::app
