#include "inputs/find_files.hpp"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

#include "extract/vertebra_level.hpp"
#include "foramen/core/error.hpp"
#include "foramen/io/mesh_file.hpp"
#include "inputs/folder_names.hpp"
#include "inputs/search_folder.hpp"
#include "io/file_bytes.hpp"
#include "io/foreign_file.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += " " + word;
  return text;
}

// The files that are read if a folder is given.
struct Kind {
  const char* what;
  bool meshes, label_maps;
  bool includes(const fs::path& path) const {
    return (meshes && is_mesh_file(path)) || (label_maps && is_label_map(path));
  }
  std::string extensions() const {
    return (meshes ? joined(mesh_extensions()) : "") + (label_maps ? joined(label_map_extensions()) : "");
  }
};
constexpr Kind meshes_only{"mesh file", true, false}, label_maps_only{"label map", false, true},
    shape_files{"mesh file and no label map", true, true};

std::string stem_of(const fs::path& file) {
  return is_label_map(file) ? label_map_stem(file) : mesh_stem(file);
}

fs::path full_path(const fs::path& path) {
  std::error_code failed;
  return fs::absolute(path, failed).lexically_normal();
}

// A file that the inputs name, by itself or by its folder.
struct Candidate {
  fs::path path;
  bool searched = false;  // found in a folder
};

// Names what a folder holds instead, such as the slices of a DICOM series, by the first files in it or in its
// first subfolder that holds any.
void refuse_foreign_files(const fs::path& folder) {
  std::vector<fs::path> files, folders;
  std::error_code failed;
  for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end; entry.increment(failed))
    (entry->is_directory(failed) && !entry->is_symlink(failed) ? folders : files).push_back(entry->path());
  std::sort(files.begin(), files.end());
  std::sort(folders.begin(), folders.end());
  constexpr std::size_t looked_at = 10;
  files.resize(std::min(files.size(), looked_at));
  for (const fs::path& file : files)
    if (fs::is_regular_file(file, failed)) io_detail::refuse_foreign(file);
  if (files.empty() && !folders.empty()) refuse_foreign_files(folders.front());
}

// What a folder lacks, and what it holds instead.
[[noreturn]] void refuse_folder(const fs::path& folder, const Kind& kind, const Skipped& skipped) {
  refuse_foreign_files(folder);
  Message message(folder.string() + ": the folder holds no " + kind.what + " (looked for" +
                  kind.extensions() + ")");
  Skipped unimportant;
  if (!kind.label_maps && !search_folder(folder, is_label_map, unimportant).empty())
    message.append({", but label maps: make meshes of their labels first", {{RemedyKind::extract_surfaces}}});
  for (const Message& note : skipped.messages()) message.append({"; " + note.text, note.remedies});
  throw InvalidInput(message);
}

std::vector<Candidate> candidates_in(const std::vector<fs::path>& inputs, const Kind& kind,
                                     Skipped& skipped) {
  std::vector<Candidate> found;
  for (const fs::path& input : inputs) {
    std::error_code failed;
    const fs::file_status status = fs::status(input, failed);
    if (fs::is_directory(status)) {
      Skipped here;
      const auto files = search_folder(
          input, [&](const fs::path& path) { return kind.includes(path); }, here);
      if (files.empty()) refuse_folder(input, kind, here);
      skipped.append(here);
      for (const fs::path& file : files) found.push_back({file, true});
    } else if (fs::exists(status)) {
      found.push_back({input});
    } else {
      const bool missing = failed == std::errc::no_such_file_or_directory;
      throw InvalidInput(input.string() + ": there is no such file or folder" +
                         (missing ? "; check the name" : " (" + failed.message() + ")"));
    }
  }
  return found;
}

bool is_vertebra_mask(const fs::path& path) {
  const std::string stem = stem_of(path);
  return is_label_map(path) && io_detail::lower_case(stem).starts_with("vertebra") &&
         level_in_file_name(stem);
}

// Passes over what lies among masks of vertebrae but is no vertebra.
void leave_other_structures(std::vector<Candidate>& candidates, Skipped& skipped) {
  std::set<fs::path> of_masks, beside_masks;
  for (const Candidate& candidate : candidates) {
    if (!is_vertebra_mask(candidate.path)) continue;
    const fs::path folder = full_path(candidate.path).parent_path();
    of_masks.insert(folder);
    if (is_kind_of_files(folder.filename().string())) beside_masks.insert(folder.parent_path());
  }
  std::erase_if(candidates, [&](const Candidate& candidate) {
    if (!is_label_map(candidate.path) || level_in_file_name(stem_of(candidate.path))) return false;
    const fs::path folder = full_path(candidate.path).parent_path();
    const bool other = of_masks.contains(folder), image = candidate.searched && beside_masks.contains(folder);
    if (other)
      skipped.add("files among masks of vertebrae whose names are no vertebrae were passed over",
                  candidate.path);
    else if (image)
      skipped.add("files beside a folder of masks of vertebrae were passed over", candidate.path);
    return other || image;
  });
}

// Sets the folder of all files if two of them have the same name.
void tell_apart(std::vector<ShapeFile>& files) {
  std::vector<StemmedFile> stems;
  for (const ShapeFile& file : files)
    stems.push_back({file.path, file.name + (is_label_map(file.path) ? "/" : "")});
  const auto by_name = [](const StemmedFile& a, const StemmedFile& b) { return a.stem < b.stem; };
  std::vector<StemmedFile> sorted = stems;
  std::stable_sort(sorted.begin(), sorted.end(), by_name);
  const auto twin = std::adjacent_find(sorted.begin(), sorted.end(),
                                       [](const auto& a, const auto& b) { return a.stem == b.stem; });
  if (twin == sorted.end()) return;
  const auto folders = folders_apart(stems);
  if (folders.empty())
    throw InvalidInput(
        twin->path.string() + " and " + (twin + 1)->path.string() +
        " have the same name without extension, which would name two shapes alike: rename one");
  for (std::size_t i = 0; i < files.size(); ++i) {
    files[i].folder = folders[i];
    files[i].name = folders[i] + "_" + files[i].name;
  }
}

FoundFiles find_files(const std::vector<fs::path>& inputs, const Kind& kind) {
  Skipped skipped;
  std::vector<Candidate> candidates = candidates_in(inputs, kind, skipped);
  if (kind.label_maps) leave_other_structures(candidates, skipped);
  FoundFiles found;
  std::set<fs::path> taken;
  for (const Candidate& candidate : candidates)
    if (taken.insert(full_path(candidate.path)).second) found.files.emplace_back(candidate.path);
  const auto in_order = [](const ShapeFile& a, const ShapeFile& b) {
    const bool a_is_map = is_label_map(a.path), b_is_map = is_label_map(b.path);
    return std::tie(a.name, a_is_map, a.path) < std::tie(b.name, b_is_map, b.path);
  };
  std::sort(found.files.begin(), found.files.end(), in_order);
  tell_apart(found.files);
  std::sort(found.files.begin(), found.files.end(), in_order);
  found.notes = skipped.messages();
  return found;
}

}  // namespace

ShapeFile::ShapeFile(fs::path file) : path(std::move(file)), name(stem_of(path)) {}

std::string ShapeFile::shown() const {
  return (folder.empty() ? "" : folder + "_") + path.filename().string();
}

LabelMapFile ShapeFile::label_map() const {
  LabelMapFile file(path);
  file.stem = name;
  if (folder.empty()) return file;
  const auto level = level_in_file_name(stem_of(path));
  file.mask_stem = folder + (level && !level->rest.empty() ? "_" + level->rest : "");
  return file;
}

FoundFiles find_meshes(const std::vector<fs::path>& inputs) { return find_files(inputs, meshes_only); }
FoundFiles find_shape_files(const std::vector<fs::path>& inputs) { return find_files(inputs, shape_files); }
FoundFiles find_label_maps(const std::vector<fs::path>& inputs) {
  return find_files(inputs, label_maps_only);
}

const ShapeFile* file_named(const std::vector<ShapeFile>& files, const std::string& name) {
  const ShapeFile* found = nullptr;
  for (const ShapeFile& file : files)
    if (file.name == name) return &file;
  for (const ShapeFile& file : files) {
    const std::string stem = stem_of(file.path);
    for (const fs::path& folder : full_path(file.path).parent_path()) {
      if (folder.string() + "_" + stem != name) continue;
      if (found != nullptr && found != &file) return nullptr;
      found = &file;
    }
  }
  return found;
}

std::vector<std::string> words_of_inputs(const std::vector<std::string>& inputs,
                                         FoundFiles (*find)(const std::vector<fs::path>&)) {
  FoundFiles found;
  try {
    found = find({inputs.begin(), inputs.end()});
  } catch (const Error&) {
    // The command itself will say what is wrong with its inputs.
  }
  std::vector<std::string> words;
  for (const std::string& input : inputs) {
    const auto file = std::find_if(found.files.begin(), found.files.end(),
                                   [&](const ShapeFile& f) { return full_path(f.path) == full_path(input); });
    words.push_back(file != found.files.end() ? file->shown()
                                              : fs::path(input).lexically_normal().filename().string());
  }
  return words;
}

}  // namespace foramen
