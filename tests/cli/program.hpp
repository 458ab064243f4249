#pragma once
/// \file
/// Runs the program as a user does.

#include <sys/wait.h>

#include <cstdio>
#include <filesystem>
#include <map>
#include <string>

#include "support/temporary_folder.hpp"

namespace foramen::testing {

struct Outcome {
  int code;            // -1: ended by a signal
  std::string output;  // stdout and stderr together
};

inline Outcome run_shell(const std::string& command) {
  FILE* pipe = popen(("(" + command + ") 2>&1").c_str(), "r");
  std::string output;
  char buffer[4096];
  while (const std::size_t count = fread(buffer, 1, sizeof buffer, pipe)) output.append(buffer, count);
  const int status = pclose(pipe);
  // A shell reports 128 + n for a program that was ended by signal n. 130 is also an exit code of the program
  // itself.
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return {code > 128 && code != 130 ? -1 : code, output};
}

/// A prefix that limits the memory of a command to far less than what wrong headers claim. With sanitizers,
/// which reserve terabytes, there is no limit.
#if !defined(__has_feature)
#define __has_feature(feature) 0  // clang's
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || __has_feature(address_sanitizer) || \
    __has_feature(thread_sanitizer)
inline const std::string in_three_gigabytes;
#else
inline const std::string in_three_gigabytes = "ulimit -v 3000000; ";
#endif

inline Outcome run(const std::string& arguments) { return run_shell(FORAMEN_PROGRAM " " + arguments); }

/// The bytes of all files of a folder except run.json, including hidden files, by their paths in the folder.
inline std::map<std::string, std::string> files_of(const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && entry.path().filename() != "run.json")
      files[fs::relative(entry.path(), folder).string()] = bytes_of(entry.path());
  return files;
}

}  // namespace foramen::testing
