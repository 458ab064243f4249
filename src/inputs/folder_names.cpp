#include "inputs/folder_names.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "extract/extract_labels.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;
using Folders = std::vector<std::string>;  // from the top to the file

Folders folders_of(const fs::path& file) {
  std::error_code failed;
  Folders folders;
  for (const fs::path& part : fs::absolute(file, failed).lexically_normal().parent_path())
    if (!is_kind_of_files(part.string())) folders.push_back(part.string());
  return folders;
}

// Drops what all have in common at the top, but leaves each at least its last folder.
void drop_shared(std::vector<Folders>& all) {
  std::size_t shared = all.front().size();
  for (const Folders& folders : all) {
    const auto apart = std::mismatch(folders.begin(), folders.end(), all.front().begin(), all.front().end());
    shared = std::min<std::size_t>(shared, apart.first - folders.begin());
  }
  for (Folders& folders : all) {
    const std::size_t dropped = std::min(shared, folders.empty() ? 0 : folders.size() - 1);
    folders.erase(folders.begin(), folders.begin() + static_cast<std::ptrdiff_t>(dropped));
  }
}

bool all_different(const std::vector<StemmedFile>& files, const std::vector<std::string>& names) {
  std::set<std::string> taken;
  for (std::size_t i = 0; i < files.size(); ++i)
    if (names[i].empty() || !taken.insert(names[i] + "_" + files[i].stem).second) return false;
  return true;
}

}  // namespace

std::vector<std::string> folders_apart(const std::vector<StemmedFile>& files) {
  std::vector<Folders> all;
  for (const StemmedFile& file : files) all.push_back(folders_of(file.path));
  if (all.empty()) return {};
  drop_shared(all);
  std::size_t deepest = 0;
  for (const Folders& folders : all) deepest = std::max(deepest, folders.size());
  std::vector<std::string> names(files.size());
  for (std::size_t distance = 1; distance <= deepest; ++distance) {
    for (std::size_t i = 0; i < all.size(); ++i)
      names[i] = all[i].empty() ? "" : all[i][all[i].size() - std::min(distance, all[i].size())];
    if (all_different(files, names)) return names;
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    names[i].clear();
    for (const std::string& folder : all[i]) names[i] += (names[i].empty() ? "" : "_") + folder;
  }
  return all_different(files, names) ? names : std::vector<std::string>{};
}

}  // namespace foramen
