#include "inputs/search_folder.hpp"

#include <algorithm>

#include "foramen/core/error.hpp"
#include "inputs/label_map_notes.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;

// Throws IoError instead of std::filesystem_error, whose message does not say what to do.
std::vector<fs::directory_entry> sorted_entries(const fs::path& folder) {
  std::error_code failed;
  std::vector<fs::directory_entry> entries;
  for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end; entry.increment(failed))
    entries.push_back(*entry);
  if (failed) throw IoError(folder.string() + ": cannot read the folder (" + failed.message() + ")");
  std::sort(entries.begin(), entries.end());
  return entries;
}

bool is_there(const fs::path& path) {
  std::error_code failed;
  return fs::exists(path, failed);
}

bool is_folder(const fs::path& path) {
  std::error_code failed;
  return fs::is_directory(path, failed);
}

}  // namespace

void Skipped::append(const Skipped& more) {
  for (const auto& [why, paths] : more.by_reason_)
    by_reason_[why].insert(by_reason_[why].end(), paths.begin(), paths.end());
}

std::vector<Message> Skipped::messages() const {
  std::vector<Message> notes;
  for (const auto& [why, paths] : by_reason_) notes.emplace_back(why + ": " + first_names(paths));
  return notes;
}

std::vector<fs::path> search_folder(const fs::path& folder,
                                    const std::function<bool(const fs::path&)>& wanted, Skipped& skipped) {
  if (is_there(folder / "run.json") || is_there(folder / "model.h5")) {
    skipped.add("the folder of a model was not searched", folder);
    return {};
  }
  if (is_folder(folder / "shapes") && is_folder(folder / "truth")) {
    skipped.add("only shapes/ was searched of a folder that also has truth/", folder);
    return search_folder(folder / "shapes", wanted, skipped);
  }
  std::vector<fs::path> found;
  for (const fs::directory_entry& entry : sorted_entries(folder)) {
    const fs::path& path = entry.path();
    std::error_code failed;
    const bool is_directory = entry.is_directory(failed);
    if (!is_directory && !(entry.is_regular_file(failed) && wanted(path))) continue;
    if (path.filename().string().starts_with("."))
      skipped.add(is_directory ? "hidden folders were not searched" : "hidden files were passed over", path);
    else if (!is_directory)
      found.push_back(path);
    else if (entry.is_symlink(failed))
      skipped.add("links to folders were not followed", path);
    else
      for (fs::path& file : search_folder(path, wanted, skipped)) found.push_back(std::move(file));
  }
  return found;
}

}  // namespace foramen
