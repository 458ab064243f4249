#pragma once
/// \file
/// The folder of the real vertebrae, which lies beside the project.

#include <filesystem>

/// Skips the test with a message if the real shapes are missing.
#define FORAMEN_NEEDS_REAL_DATA()                                 \
  if (!std::filesystem::is_directory(FORAMEN_DATA_DIR "/lumbar")) \
  GTEST_SKIP() << "needs the real vertebrae, which are not in " << FORAMEN_DATA_DIR

namespace foramen::testing {

inline std::filesystem::path data_dir() { return FORAMEN_DATA_DIR; }

}  // namespace foramen::testing
