#pragma once
/// \file
/// Where tests find the real vertebrae. They stand beside the project, not in it.

#include <filesystem>

/// Skips the test, visibly, where the real shapes are absent.
#define FORAMEN_NEEDS_REAL_DATA()                                 \
  if (!std::filesystem::is_directory(FORAMEN_DATA_DIR "/lumbar")) \
  GTEST_SKIP() << "needs the real vertebrae, which are not in " << FORAMEN_DATA_DIR

namespace foramen::testing {

inline std::filesystem::path data_dir() { return FORAMEN_DATA_DIR; }

}  // namespace foramen::testing
