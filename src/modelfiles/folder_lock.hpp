#pragma once
/// \file
/// A lock that lets only one build at a time write into a model's folder.

#include <filesystem>

namespace foramen {

/// Locks a folder for this process. The destructor unlocks it, and the system does so if the process ends in
/// any other way. The constructor throws InvalidInput if another process holds the lock. On a file system
/// without locks, nothing is locked.
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
