#include "inputs/shape_of_file.hpp"

#include <string_view>

namespace foramen {
namespace {

namespace fs = std::filesystem;

// The longest name with which the text begins as a whole word.
std::optional<ShapeOfFile> longest_beginning(const std::string& text, const std::vector<std::string>& names) {
  std::optional<ShapeOfFile> best;
  std::size_t longest = 0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string& name = names[i];
    if (name.size() <= longest || !text.starts_with(name)) continue;
    const bool whole = text.size() == name.size();
    if (!whole && std::string_view("_-. ").find(text[name.size()]) == std::string_view::npos) continue;
    longest = name.size();
    best = ShapeOfFile{static_cast<int>(i), whole ? "" : text.substr(name.size() + 1)};
  }
  return best;
}

}  // namespace

std::optional<ShapeOfFile> shape_of_file(const fs::path& file, const std::string& stem,
                                         const std::vector<std::string>& names) {
  if (auto found = longest_beginning(stem, names)) return found;
  std::error_code failed;
  std::vector<std::string> folders;  // the nearest first
  for (fs::path folder = fs::absolute(file, failed).lexically_normal().parent_path();
       folder.has_relative_path(); folder = folder.parent_path())
    folders.push_back(folder.filename().string());
  for (const std::string& folder : folders)
    if (auto found = longest_beginning(folder + "_" + stem, names); found && found->rest != stem)
      return found;
  for (std::size_t f = 0; f < folders.size(); ++f)
    for (std::size_t i = 0; i < names.size(); ++i)
      if (folders[f] == names[i] || (f + 1 < folders.size() && folders[f + 1] + "_" + folders[f] == names[i]))
        return ShapeOfFile{static_cast<int>(i), stem};
  return std::nullopt;
}

}  // namespace foramen
