#pragma once
/// \file
/// A store of finished stages in a folder.

#include <atomic>
#include <filesystem>
#include <mutex>
#include <string>
#include <vector>

#include "foramen/core/stage_store.hpp"

namespace foramen {

/// Each result is one file, named by the hash of its key, with a checksum of its content. An entry that is
/// damaged (truncated, flipped bits) counts as missing and a note is made. Files are written atomically, so
/// several processes may use one folder at once.
class FolderStore : public StageStore {
 public:
  enum class Use {
    alone,   ///< no other process uses the folder; temporary files of killed processes are removed
    shared,  ///< other processes may be writing to the folder
  };
  /// \param program  identifies the program and its version; entries of another program are never used
  FolderStore(std::filesystem::path folder, std::string program, Use use);

  /// SHA-256.
  std::string digest(std::string_view bytes) const override;
  std::optional<std::string> load(const std::string& key) override;
  /// If an entry cannot be written, a note is made, later calls store nothing and the run goes on. A folder
  /// of Use::alone is then removed, because the disk may be full and the run needs the space for its output.
  void keep(const std::string& key, std::string_view bytes) override;

  /// Number of results that load() has returned.
  int taken_up() const { return taken_up_; }
  /// Messages for the user about damaged entries and failed writes.
  std::vector<std::string> notes() const;
  /// Removes the folder; later calls of keep() store nothing.
  void remove();

 private:
  std::filesystem::path file_of(const std::string& key) const;
  void note(std::string text);

  std::filesystem::path folder_;
  std::string program_;
  Use use_;
  std::atomic<bool> keeping_{true};
  std::atomic<int> taken_up_{0};
  mutable std::mutex mutex_;
  std::vector<std::string> notes_;
};

}  // namespace foramen
