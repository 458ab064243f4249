#include "io/atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <string>
#include <system_error>
#include <vector>

#include "foramen/core/error.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& what, int error) {
  throw IoError(path.string() + ": " + what + " (" + std::generic_category().message(error) +
                "); check the folder, its permissions and the space on the disk");
}

class Descriptor {
 public:
  Descriptor(const fs::path& path, int flags) : fd_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {}
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  bool open() const { return fd_ >= 0; }
  int get() const { return fd_; }

 private:
  int fd_;
};

std::string host_name() {
  std::array<char, 65> name{};  // Linux has no longer ones
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

constexpr std::string_view temporary_mark = ".foramen-tmp";

// Unique within this process by the counter, between processes by the process id, and between machines that
// share the folder by the host's name. The extension stays, since some libraries choose the format by it.
fs::path temporary_beside(const fs::path& path) {
  static std::atomic<unsigned> counter{0};
  std::string name = ".";
  name += path.stem().string();
  name += '.' + host_name() + '-' + std::to_string(::getpid()) + '-' + std::to_string(counter++);
  name += temporary_mark;
  name += path.extension().string();
  return path.parent_path() / name;
}

void check_target(const fs::path& path) {
  std::error_code ignored;
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, ignored))
    throw IoError(path.string() + ": its folder does not exist; create it first");
  const auto status = fs::status(path, ignored);
  // Renaming over a device or a folder would destroy it or fail late.
  if (fs::exists(status) && !fs::is_regular_file(status))
    throw IoError(path.string() + ": exists and is not a regular file; choose another name");
}

void flush_to_disk(const fs::path& path, int flags) {
  const Descriptor file(path, flags);
  if (!file.open() || ::fsync(file.get()) != 0) fail(path, "cannot be flushed to disk", errno);
}

// Flushes the rename to disk. Some file systems cannot flush a folder; the file is complete all the same, so
// a failure here is ignored.
void flush_folder(const fs::path& path) {
  const Descriptor folder(path.has_parent_path() ? path.parent_path() : fs::path("."),
                          O_RDONLY | O_DIRECTORY);
  if (folder.open()) ::fsync(folder.get());
}

// Removes the temporary file unless it was renamed.
class Temporary {
 public:
  explicit Temporary(const fs::path& target) : target_(target), path_(temporary_beside(target)) {}
  ~Temporary() {
    std::error_code ignored;
    if (!done_) fs::remove(path_, ignored);
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  const fs::path& path() const { return path_; }
  void rename_over_target() {
    if (::rename(path_.c_str(), target_.c_str()) != 0) fail(target_, "cannot be replaced", errno);
    done_ = true;
    flush_folder(target_);
  }

 private:
  fs::path target_, path_;
  bool done_ = false;
};

void write_all(int fd, std::string_view contents, const fs::path& path) {
  while (!contents.empty()) {
    const auto written = ::write(fd, contents.data(), contents.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(path, "cannot be written", errno);
    contents.remove_prefix(written);
  }
}

}  // namespace

void make_folder(const fs::path& folder) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed || !fs::is_directory(folder))
    throw IoError(folder.string() + ": cannot be made a folder (" + failed.message() + "); give another",
                  {{RemedyKind::another_output}});
}

void write_file(const fs::path& path, std::string_view contents) {
  check_target(path);
  Temporary temporary(path);
  {
    const Descriptor file(temporary.path(), O_WRONLY | O_CREAT | O_EXCL);
    if (!file.open()) fail(path, "cannot be created", errno);
    write_all(file.get(), contents, path);
    if (::fsync(file.get()) != 0) fail(path, "cannot be flushed to disk", errno);
  }
  temporary.rename_over_target();
}

void write_file_with(const fs::path& path, const std::function<void(const fs::path& temporary)>& write) {
  check_target(path);
  Temporary temporary(path);
  write(temporary.path());
  std::error_code ignored;
  if (!fs::is_regular_file(temporary.path(), ignored)) fail(path, "was not written", ENOENT);
  flush_to_disk(temporary.path(), O_RDONLY);
  temporary.rename_over_target();
}

void remove_leftovers(const fs::path& folder) {
  std::error_code failed;
  std::vector<fs::path> leftovers;
  for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end; entry.increment(failed)) {
    const std::string name = entry->path().filename().string();
    if (name.starts_with('.') && name.find(temporary_mark) != std::string::npos)
      leftovers.push_back(entry->path());
  }
  for (const fs::path& leftover : leftovers) fs::remove(leftover, failed);
}

}  // namespace foramen
