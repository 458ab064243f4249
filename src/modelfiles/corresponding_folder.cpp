#include "modelfiles/corresponding_folder.hpp"

#include "foramen/core/error.hpp"
#include "foramen/io/mesh_file.hpp"
#include "inputs/read_cohort.hpp"
#include "inputs/surface_size.hpp"

namespace foramen {
namespace {

CorrespondingFolder read_files(const FoundFiles& found, const InputUnit& unit) {
  CorrespondingFolder result;
  SizeCheck sizes(unit);
  result.notes = found.notes;
  for (const ShapeFile& file : found.files) {
    MeshFile read = read_mesh(file.path);
    for (const Message& note : read.notes) result.notes.push_back(note.about(file.shown()));
    if (result.names.empty()) {
      result.triangles = read.soup.triangles;
    } else if (read.soup.triangles != result.triangles ||
               read.soup.points.size() != result.shapes.front().size()) {
      throw InvalidInput(file.path.string() + ": has other triangles or another number of vertices than " +
                         result.names.front() +
                         "; corresponding meshes must have the same triangles in the same order");
    }
    for (Vec3& p : read.soup.points) p *= millimetres_per(unit.length);
    sizes.add(file.path.string(), read.soup.points);
    result.names.push_back(file.name);
    if (!file.folder.empty()) result.folders.push_back(file.folder);
    result.shapes.push_back(std::move(read.soup.points));
    result.spaces.push_back(read.space.value_or(AnatomicalSpace::lps));
  }
  if (const auto note = sizes.note()) result.notes.push_back(*note);
  return result;
}

}  // namespace

CorrespondingFolder read_corresponding(const std::filesystem::path& folder, const InputUnit& unit) {
  return read_files(find_meshes({folder}), unit);
}

TrueCorrespondence read_truth(const std::filesystem::path& folder, const std::vector<std::string>& names,
                              const InputUnit& unit) {
  const FoundFiles found = find_meshes({folder});
  CorrespondingFolder all = read_files(found, unit);  // in the order of the files
  TrueCorrespondence truth;
  truth.triangles = std::move(all.triangles);
  for (const std::string& name : names) {
    const ShapeFile* file = file_named(found.files, name);
    if (file == nullptr)
      throw InvalidInput(folder.string() + ": there is no true correspondence for the shape " + name +
                         "; its file must have this name");
    truth.shapes.push_back(all.shapes[file - found.files.data()]);
  }
  return truth;
}

}  // namespace foramen
