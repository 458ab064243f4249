#include "inputs/read_marks.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "foramen/core/error.hpp"
#include "foramen/io/label_map.hpp"
#include "inputs/search_folder.hpp"
#include "inputs/shape_of_file.hpp"
#include "inputs/voxel_regions.hpp"
#include "io/mark_file.hpp"
#include "io/vertex_labels.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_of(const std::vector<fs::path>& inputs, bool (*wanted)(const fs::path&),
                               const char* what, Skipped& skipped) {
  std::vector<fs::path> files;
  for (const fs::path& input : inputs) {
    std::error_code failed;
    if (fs::is_directory(input, failed)) {
      const auto found = search_folder(input, wanted, skipped);
      if (found.empty()) throw InvalidInput(input.string() + ": the folder holds no " + what);
      files.insert(files.end(), found.begin(), found.end());
    } else if (fs::exists(input, failed)) {
      files.push_back(input);
    } else {
      throw InvalidInput(input.string() + ": there is no such file or folder; check the name");
    }
  }
  return files;
}

std::string some_of(const std::vector<std::string>& names) {
  constexpr std::size_t most = 5;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), most); ++i) text += (i > 0 ? ", " : "") + names[i];
  return text + (names.size() > most ? ", ..." : "");
}

// Names of marked shapes that are not in the cohort.
class OtherShapes {
 public:
  void add(const std::string& name) {
    if (seen_.insert(name).second) names_.push_back(name);
  }
  void note_or_refuse(bool any_found, const char* what, const std::vector<std::string>& names,
                      std::vector<Message>& notes) const {
    if (!any_found)
      throw InvalidInput(std::string("the ") + what + " are of no shape here (found " + some_of(names_) +
                         "; the shapes are " + some_of(names) + "): name each file as its shape");
    if (!names_.empty())
      notes.emplace_back(std::string("passed over ") + what + " of " + std::to_string(names_.size()) +
                         " shapes or files that are not among the shapes here: " + some_of(names_));
  }

 private:
  std::set<std::string> seen_;
  std::vector<std::string> names_;
};

bool is_region_file(const fs::path& path) { return is_label_list(path) || is_label_map(path); }

// From LPS to RAS and back.
Vec3 turned(const Vec3& p) { return {-p.x(), -p.y(), p.z()}; }

}  // namespace

ReadMarks read_marks(const std::vector<fs::path>& inputs, const MarkedShapes& shapes, const InputUnit& unit) {
  ReadMarks result;
  result.marks.resize(shapes.names.size());
  Skipped skipped;
  OtherShapes others;
  bool any = false;
  for (const fs::path& path :
       files_of(inputs, is_mark_file, "marks (looked for .json, .fcsv and .csv)", skipped)) {
    MarkFile file = read_mark_file(path);
    const std::string stem = mark_stem(path);
    for (NamedMarks& named : file.shapes) {
      const std::string called = named.shape.empty()         ? stem
                                 : is_mesh_file(named.shape) ? mesh_stem(named.shape)
                                                             : named.shape;
      std::optional<ShapeOfFile> of;
      if (named.shape.empty()) {
        of = shape_of_file(path, stem, shapes.names);
      } else if (const auto found = std::find(shapes.names.begin(), shapes.names.end(), called);
                 found != shapes.names.end()) {
        of = ShapeOfFile{static_cast<int>(found - shapes.names.begin()), ""};
      }
      if (!of) {
        others.add(called);
        continue;
      }
      any = true;
      const bool turn = file.space && *file.space != shapes.spaces[of->shape];
      for (Mark& mark : named.marks) {
        if (mark.name.empty()) mark.name = of->rest;
        if (mark.name.empty())
          throw InvalidInput(path.string() +
                             ": a curve has no name; give its points labels like rim-1, rim-2, or name its "
                             "file as the shape and the curve, as in SHAPE_rim.mrk.json");
        for (Vec3& p : mark.points) p = (turn ? turned(p) : p) * millimetres_per(unit.length);
        result.marks[of->shape].push_back(std::move(mark));
      }
    }
  }
  result.notes = skipped.messages();
  others.note_or_refuse(any, "marks", shapes.names, result.notes);
  return result;
}

ReadRegions read_regions(const std::vector<fs::path>& inputs, const MarkedShapes& shapes) {
  FORAMEN_ASSERT(shapes.surfaces.empty() || shapes.surfaces.size() == shapes.names.size());
  ReadRegions result;
  result.regions.resize(shapes.names.size());
  Skipped skipped;
  OtherShapes others;
  std::vector<fs::path> of_shape(shapes.names.size());
  bool any = false;
  for (const fs::path& path : files_of(
           inputs, is_region_file, "labels (looked for .txt, .ply, .vtk, .vtp and label maps)", skipped)) {
    const std::string stem = is_label_map(path) ? label_map_stem(path) : path.stem().string();
    const auto of = shape_of_file(path, stem, shapes.names);
    if (!of) {
      others.add(stem);
      continue;
    }
    any = true;
    if (!of_shape[of->shape].empty())
      throw InvalidInput(of_shape[of->shape].string() + " and " + path.string() + " are both labels of " +
                         shapes.names[of->shape] + ": leave one out");
    of_shape[of->shape] = path;
    result.regions[of->shape] =
        is_label_map(path)
            ? voxel_regions(read_label_layers(path), shapes.surfaces.at(of->shape), shapes.spaces[of->shape])
            : regions_of_labels(read_vertex_labels(path));
  }
  result.notes = skipped.messages();
  others.note_or_refuse(any, "labels", shapes.names, result.notes);
  return result;
}

}  // namespace foramen
