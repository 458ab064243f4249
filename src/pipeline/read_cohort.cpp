#include "foramen/pipeline/read_cohort.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>
#include <utility>
#include <variant>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/core/parallel.hpp"
#include "foramen/io/sha256.hpp"
#include "foramen/topology/inspect_mesh.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;

bool is_mesh_file(const fs::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto& known = mesh_extensions();
  return std::find(known.begin(), known.end(), extension) != known.end();
}

// std::filesystem reports through std::filesystem_error, which names no remedy.
std::vector<fs::path> meshes_in_folder(const fs::path& folder) {
  std::error_code failed;
  std::vector<fs::path> found;
  for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end; entry.increment(failed))
    if (entry->is_regular_file() && is_mesh_file(entry->path())) found.push_back(entry->path());
  if (failed) throw IoError(folder.string() + ": cannot read the folder (" + failed.message() + ")");
  if (found.empty()) {
    std::string known;
    for (const auto& extension : mesh_extensions()) known += " " + extension;
    throw InvalidInput(folder.string() + ": the folder holds no mesh file (looked for" + known + ")");
  }
  return found;
}

std::string millimetres(double value) {
  std::ostringstream text;
  text.precision(3);
  text << value;
  return text.str();
}

void require_plausible_size(double diagonal, LengthUnit unit) {
  const double mm = diagonal * millimetres_per(unit);
  if (mm >= smallest_diagonal_mm && mm <= largest_diagonal_mm) return;
  std::string message =
      "the bounding box has a diagonal of " + millimetres(mm) + " mm; a vertebra has 20 to 250 mm";
  if (const auto likely = likely_unit(diagonal))
    message += ": the file is probably in " + std::string(name(*likely)) + ", give --units " +
               std::string(name(*likely));
  else if (unit != LengthUnit::millimetre && diagonal >= smallest_diagonal_mm &&
           diagonal <= largest_diagonal_mm)
    message += ": the file is probably in mm, leave --units out";
  throw InvalidInput(message);
}

// The shape that this one is a copy of; null if there is none.
const InputShape* same_surface(const InputShape& shape, const std::vector<InputShape>& others) {
  const auto found = std::find_if(others.begin(), others.end(), [&](const InputShape& other) {
    const auto a = shape.mesh.positions(), b = other.mesh.positions();
    return shape.mesh.triangles() == other.mesh.triangles() && std::equal(a.begin(), a.end(), b.begin(), b.end());
  });
  return found == others.end() ? nullptr : &*found;
}

}  // namespace

std::vector<fs::path> find_meshes(const std::vector<fs::path>& inputs) {
  std::vector<fs::path> files;
  for (const fs::path& input : inputs) {
    std::error_code failed;
    const fs::file_status status = fs::status(input, failed);
    if (fs::is_directory(status)) {
      const auto found = meshes_in_folder(input);
      files.insert(files.end(), found.begin(), found.end());
    } else if (fs::exists(status)) {
      files.push_back(input);
    } else {
      throw InvalidInput(input.string() + ": there is no such file or folder (" + failed.message() + ")");
    }
  }
  std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
    return std::pair(a.stem(), a) < std::pair(b.stem(), b);
  });
  files.erase(std::unique(files.begin(), files.end()), files.end());
  for (std::size_t i = 1; i < files.size(); ++i)
    if (files[i].stem() == files[i - 1].stem())
      throw InvalidInput(
          files[i - 1].string() + " and " + files[i].string() +
          " have the same name without extension, which would name two shapes alike: rename one");
  return files;
}

InputShape read_shape(const fs::path& file, LengthUnit unit) {
  InputShape shape;
  shape.stem = file.stem().string();
  shape.file_name = file.filename().string();
  MeshFile read = read_mesh(file);
  shape.sha256 = sha256_of_file(file);
  shape.space = read.space.value_or(AnatomicalSpace::lps);
  const MeshReport report = inspect_mesh(read.soup);
  if (const auto obstacle = obstacle_to_model(report))
    throw TopologyError(file.string() + ": " + obstacle->finding + "; " + obstacle->remedy);
  try {
    require_plausible_size(report.box.diagonal(), unit);
  } catch (const InvalidInput& e) {
    throw InvalidInput(file.string() + ": " + e.what());
  }
  const double scale = millimetres_per(unit);
  if (unit != LengthUnit::millimetre)
    for (Vec3& p : read.soup.points) p *= scale;
  shape.mesh = build_mesh(std::move(read.soup));
  shape.was_inward = report.inward;
  if (shape.was_inward) shape.mesh = reversed(shape.mesh);
  return shape;
}

Cohort read_cohort(const std::vector<fs::path>& files, LengthUnit unit, const RunContext& ctx) {
  std::vector<std::variant<std::monostate, InputShape, LeftOut>> results(files.size());
  parallel_for(static_cast<int>(files.size()), ctx, [&](int i) {
    const fs::path& file = files[static_cast<std::size_t>(i)];
    auto& result = results[static_cast<std::size_t>(i)];
    try {
      result = read_shape(file, unit);
    } catch (const Cancelled&) {
      throw;
    } catch (const Error& e) {
      result = LeftOut{file.stem().string(), file.filename().string(), {}, e.what()};
    }
  });
  Cohort cohort;
  for (auto& result : results) {
    auto* shape = std::get_if<InputShape>(&result);
    if (shape == nullptr)
      cohort.left_out.push_back(std::get<LeftOut>(std::move(result)));
    else if (const InputShape* original = same_surface(*shape, cohort.shapes))
      cohort.left_out.push_back({shape->stem, shape->file_name, shape->sha256,
                                 "the same surface as " + original->file_name +
                                     ", vertex by vertex; a model counts a shape once: remove the copy"});
    else
      cohort.shapes.push_back(std::move(*shape));
  }
  return cohort;
}

}  // namespace foramen
