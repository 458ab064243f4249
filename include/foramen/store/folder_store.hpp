#pragma once
/// \file
/// A store of stages in a folder.

#include <atomic>
#include <filesystem>
#include <mutex>
#include <string>
#include <vector>

#include "foramen/core/stage_store.hpp"

namespace foramen {

/// One file a result, named by the hash of its key, with a checksum of what it holds. An entry that is not
/// what was written (cut off, flipped bits) is never believed: it counts as not there, with a note. Files
/// appear whole or not at all, so several processes may use one folder at once.
class FolderStore : public StageStore {
 public:
  enum class Use {
    alone,   ///< no other process uses the folder: what killed ones left half-written is removed
    shared,  ///< others may be writing now
  };
  /// \param program  names the program; what another program has kept is never taken up
  FolderStore(std::filesystem::path folder, std::string program, Use use);

  /// SHA-256.
  std::string digest(std::string_view bytes) const override;
  std::optional<std::string> load(const std::string& key) override;
  /// If it cannot be written, nothing is kept any more, with a note, and the work goes on; a folder used
  /// alone is then given up, since the disk may be full.
  void keep(const std::string& key, std::string_view bytes) override;

  /// Stages that need not be done again.
  int taken_up() const { return taken_up_; }
  /// What the user should know.
  std::vector<std::string> notes() const;
  /// Removes the folder: nothing is to be taken up any more.
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
