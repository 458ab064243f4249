#pragma once
/// \file
/// One build at a time in a model's folder.

#include <filesystem>

namespace foramen {

/// Holds a folder for this process until destroyed; the system lets go of it however the process ends. Throws
/// InvalidInput if another holds it. Where the file system knows no locks there is none.
class FolderLock {
 public:
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int descriptor_;
};

}  // namespace foramen
