#pragma once
/// \file
/// The store of finished stages: MODEL/.resume, from which an interrupted build goes on.

#include <atomic>
#include <filesystem>
#include <mutex>
#include <string>
#include <vector>

#include "foramen/core/stage_store.hpp"
#include "foramen/stages/build_model.hpp"

namespace foramen {

/// One file a finished stage, named by the hash of its key, with a checksum of what it holds. An entry that
/// is not what was written (cut off, flipped bits) is never believed: it counts as not there, with a note.
class ResumeStore : public StageStore {
 public:
  enum class Start {
    anew,   ///< what an earlier build left is removed
    resume  ///< and here it is taken up
  };
  ResumeStore(const std::filesystem::path& model_folder, Start start);

  std::optional<std::string> load(const std::string& key) override;
  /// If it cannot be written, nothing is kept any more, what was is given up, with a note, and the build goes
  /// on.
  void keep(const std::string& key, std::string_view bytes) override;

  /// Stages that need not be done again.
  int taken_up() const { return taken_up_; }
  /// What the user should know.
  std::vector<std::string> notes() const;
  /// At success: nothing is to be taken up any more.
  void remove();

 private:
  std::filesystem::path file_of(const std::string& key) const;
  void note(std::string text);

  std::filesystem::path folder_;
  std::atomic<bool> keeping_{true};
  std::atomic<int> taken_up_{0};
  mutable std::mutex mutex_;
  std::vector<std::string> notes_;
};

/// Names all that the stages of a build depend on, by content: the surfaces, the options, this very program.
std::string stage_scope(std::span<const Shape> shapes, const BuildOptions& options);

}  // namespace foramen
