#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>

#include "foramen/core/error.hpp"
#include "io/hdf5_file.hpp"

namespace foramen::io_detail {
namespace {

constexpr char survived = 'y';

struct Pipe {
  int read_end = -1, write_end = -1;
  Pipe() {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) == 0) {
      read_end = ends[0];
      write_end = ends[1];
    }
  }
  ~Pipe() {
    close(read_end);
    close(write_end);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  static void close(int& end) {
    if (end >= 0) ::close(end);
    end = -1;
  }
};

// Prepares the child process for a crash: the signal handlers of the program are removed, so that they do not
// run twice, no core file is written, nothing is printed and CPU time is limited.
void expect_the_worst(int most_seconds) {
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXCPU}) std::signal(signal, SIG_DFL);
  const auto most = static_cast<rlim_t>(most_seconds);
  const rlimit no_core{0, 0}, seconds{most, most};
  ::setrlimit(RLIMIT_CORE, &no_core);
  ::setrlimit(RLIMIT_CPU, &seconds);
  if (const int nowhere = ::open("/dev/null", O_WRONLY); nowhere >= 0) {
    ::dup2(nowhere, STDOUT_FILENO);
    ::dup2(nowhere, STDERR_FILENO);
  }
}

[[noreturn]] void run_child(const std::function<void()>& read, int most_seconds, int write_end) {
  expect_the_worst(most_seconds);
  try {
    read();
  } catch (...) {  // the caller gets the same exception when it reads
  }
  const bool told = ::write(write_end, &survived, 1) == 1;
  ::_exit(told ? 0 : 1);
}

}  // namespace

void require_survival(const std::filesystem::path& path, const std::function<void()>& read,
                      int most_seconds) {
  const auto no_process = [&] {
    throw IoError(path.string() +
                  ": HDF5 files are first read in a process of their own, which cannot be started (" +
                  std::strerror(errno) + "); free memory or allow more processes");
  };
  Pipe pipe;
  if (pipe.read_end < 0) no_process();
  const pid_t child = ::fork();
  if (child < 0) no_process();
  if (child == 0) run_child(read, most_seconds, pipe.write_end);
  Pipe::close(pipe.write_end);  // so that read() below ends when the child ends
  char told = 0;
  while (::read(pipe.read_end, &told, 1) < 0 && errno == EINTR) {
  }
  while (::waitpid(child, nullptr, 0) < 0 && errno == EINTR) {
  }
  if (told != survived)
    throw IoError(path.string() +
                  ": the HDF5 library does not survive reading it; the file is damaged: write it again with "
                  "the program that made it");
}

}  // namespace foramen::io_detail
