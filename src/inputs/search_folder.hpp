#pragma once
/// \file
/// The files in a folder and its subfolders.

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "foramen/core/remedy.hpp"

namespace foramen {

/// What a search passed over, collected over several folders.
class Skipped {
 public:
  void add(const std::string& why, const std::filesystem::path& what) {
    by_reason_[why].push_back(what.string());
  }
  void append(const Skipped& more);
  /// One note a reason, with the first paths.
  std::vector<Message> messages() const;

 private:
  std::map<std::string, std::vector<std::string>> by_reason_;
};

/// The wanted files in a folder and its subfolders, in sorted order, see find_meshes(). Throws IoError if a
/// folder cannot be read.
std::vector<std::filesystem::path> search_folder(
    const std::filesystem::path& folder, const std::function<bool(const std::filesystem::path&)>& wanted,
    Skipped& skipped);

}  // namespace foramen
