#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

#include "exchange/exchange_set.hpp"
#include "foramen/core/error.hpp"
#include "foramen/io/mesh_file.hpp"
#include "inputs/surface_size.hpp"
#include "io/named_points.hpp"
#include "io/shapeworks_project.hpp"
#include "modelfiles/atlas_file.hpp"
#include "modelfiles/corresponding_folder.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;

// Converts RAS to LPS, and LPS to RAS: half a turn about the third axis.
Eigen::Matrix4d half_turn() { return Eigen::Vector4d(-1, -1, 1, 1).asDiagonal(); }

void turn(std::vector<Vec3>& points) {
  for (Vec3& p : points) p = Vec3(-p.x(), -p.y(), p.z());
}

void turn(StatismoModel& model) {
  turn(model.points);
  for (Eigen::Index row = 0; row < model.mean.size(); ++row) {
    if (row % 3 == 2) continue;
    model.mean[row] = -model.mean[row];
    model.basis.row(row) = -model.basis.row(row);
  }
}

bool is_ras(const fs::path& mesh) {
  return fs::exists(mesh) && read_mesh(mesh).space == AnatomicalSpace::ras;
}

// Adds the training shapes of the set's model, reconstructed from their scores.
void add_training_shapes(ExchangeSet& set) {
  const StatismoModel& model = *set.model;
  if (std::ssize(model.shape_uris) == model.scores.cols())
    for (const std::string& uri : model.shape_uris) set.names.push_back(fs::path(uri).stem().string());
  else
    for (Eigen::Index i = 0; i < model.scores.cols(); ++i)
      set.names.push_back("shape" + std::to_string(i + 1));
  for (Eigen::Index i = 0; i < model.scores.cols(); ++i)
    set.shapes.push_back(
        unflattened(model.mean + model.basis * model.variance.cwiseSqrt().cwiseProduct(model.scores.col(i))));
  set.to_common.assign(set.shapes.size(), Eigen::Matrix4d::Identity());
  if (set.shapes.empty())
    set.notes.emplace_back(
        "the model holds no scores of its training shapes: only the model can be converted");
  else
    set.notes.emplace_back("shapes are the model's own of its training shapes, in the model's coordinates");
  // A model says its unit, so its shapes are told and not refused.
  SizeCheck sizes({LengthUnit::millimetre, true});
  for (std::size_t i = 0; i < set.shapes.size(); ++i) sizes.add(set.names[i], set.shapes[i]);
  if (const auto note = sizes.note()) set.notes.push_back(*note);
}

// Reads meshes and converts those in RAS to LPS. Returns for each mesh whether it was in RAS.
std::vector<bool> read_meshes(ExchangeSet& set, const fs::path& folder, const InputUnit& unit) {
  CorrespondingFolder read = read_corresponding(folder, unit);
  set.names = std::move(read.names);
  set.shapes = std::move(read.shapes);
  set.triangles = std::move(read.triangles);
  set.notes.insert(set.notes.end(), read.notes.begin(), read.notes.end());
  std::vector<bool> turned;
  for (std::size_t i = 0; i < read.spaces.size(); ++i) {
    turned.push_back(read.spaces[i] == AnatomicalSpace::ras);
    if (turned.back()) turn(set.shapes[i]);
  }
  const auto count = std::count(turned.begin(), turned.end(), true);
  if (count > 0)
    set.notes.push_back(std::to_string(count) + " of " + std::to_string(turned.size()) +
                        " meshes are in RAS axes and were turned to LPS (x and y change sign)");
  return turned;
}

// Adds the transforms of a build, from the shapes to the model, both after conversion to LPS.
void add_transforms(ExchangeSet& set, const fs::path& atlas_file, const std::vector<bool>& turned,
                    bool model_turned) {
  const Atlas atlas = read_atlas(atlas_file);
  for (std::size_t i = 0; i < set.names.size(); ++i) {
    const auto found = std::find(atlas.names.begin(), atlas.names.end(), set.names[i]);
    if (found == atlas.names.end())
      throw InvalidInput(atlas_file.string() + ": has no shape " + set.names[i] +
                         "; the model's folder holds files of different builds: build it again");
    Eigen::Matrix4d transform = atlas.transforms[found - atlas.names.begin()];
    if (turned[i]) transform = transform * half_turn();
    if (model_turned) transform = half_turn() * transform;
    set.to_common.push_back(transform);
  }
}

ExchangeSet read_model_file(const fs::path& file) {
  ExchangeSet set;
  set.model = read_statismo(file);
  set.triangles = set.model->triangles;
  for (const Message& note : set.model->notes) set.notes.push_back(note.about(file.filename().string()));
  // Only model.h5 of a build can be in RAS. Other files in its folder were written by `convert`, in LPS.
  if (file.filename() == "model.h5" && is_ras(file.parent_path() / "mean.ply")) {
    turn(*set.model);
    set.notes.emplace_back("the model is in RAS axes and was turned to LPS (x and y change sign)");
  }
  return set;
}

ExchangeSet read_model_folder(const fs::path& folder, const InputUnit& unit) {
  ExchangeSet set = read_model_file(folder / "model.h5");
  if (!fs::is_directory(folder / "corresponding")) {
    add_training_shapes(set);
    return set;
  }
  const std::vector<bool> turned = read_meshes(set, folder / "corresponding", unit);
  if (set.model->scores.cols() != std::ssize(set.names) || set.triangles != set.model->triangles)
    throw InvalidInput(folder.string() +
                       ": corresponding/ and model.h5 are not of the same shapes; build the model again");
  if (fs::exists(folder / "atlas.h5"))
    add_transforms(set, folder / "atlas.h5", turned, is_ras(folder / "mean.ply"));
  return set;
}

ExchangeSet read_points(std::vector<NamedPoints> specimens) {
  ExchangeSet set;
  for (NamedPoints& specimen : specimens) {
    set.names.push_back(std::move(specimen.name));
    set.shapes.push_back(std::move(specimen.points));
  }
  return set;
}

ExchangeSet read_tps_file(const fs::path& file) {
  TpsFile tps = read_tps(file);
  ExchangeSet set = read_points(std::move(tps.specimens));
  for (const std::string& note : tps.notes) set.notes.emplace_back(file.filename().string() + ": " + note);
  return set;
}

ExchangeSet read_project(const fs::path& file) {
  ExchangeSet set;
  for (const ShapeWorksSubject& subject : read_shapeworks(file)) {
    if (subject.local_particles.empty())
      throw InvalidInput(file.string() + ": the subject " + subject.name +
                         " has no particles; optimise the project in ShapeWorks first");
    set.names.push_back(subject.name);
    set.shapes.push_back(read_particles(file.parent_path() / subject.local_particles));
    set.to_common.emplace_back(subject.procrustes * subject.alignment);
  }
  return set;
}

void to_millimetres(ExchangeSet& set, LengthUnit unit) {
  const double millimetres = millimetres_per(unit);
  for (auto& shape : set.shapes)
    for (Vec3& p : shape) p *= millimetres;
  for (Eigen::Matrix4d& transform : set.to_common) transform.topRightCorner<3, 1>() *= millimetres;
}

constexpr std::string_view particles_extension = ".particles", local = "_local", world = "_world";

// The files of particles in a folder by the names of their subjects. ShapeWorks writes NAME_local.particles,
// in the coordinates of the subject, and NAME_world.particles, which are aligned; the former are taken.
std::map<std::string, fs::path> particles_in(const fs::path& folder) {
  std::map<std::string, fs::path> found;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (!entry.is_regular_file() || entry.path().extension() != particles_extension) continue;
    std::string name = entry.path().stem().string();
    const bool is_world = name.ends_with(world);
    if (is_world || name.ends_with(local)) name.resize(name.size() - local.size());
    if (const auto [place, is_new] = found.emplace(name, entry.path()); !is_new && !is_world)
      place->second = entry.path();
  }
  return found;
}

ExchangeSet read_particles_folder(const std::map<std::string, fs::path>& files) {
  ExchangeSet set;
  for (const auto& [name, file] : files) {
    set.names.push_back(name);
    set.shapes.push_back(read_particles(file));
  }
  return set;
}

ExchangeSet read_by_kind(const ConvertRequest& request) {
  const fs::path& input = request.input;
  if (!fs::exists(input)) throw IoError(input.string() + ": there is no such file or folder; check the name");
  if (fs::is_directory(input)) {
    if (fs::exists(input / "model.h5")) return read_model_folder(input, request.unit);
    ExchangeSet set;
    const auto has_mesh = [](const fs::directory_entry& entry) { return is_mesh_file(entry.path()); };
    const auto files = particles_in(input);
    if (files.empty() || std::any_of(fs::directory_iterator(input), fs::directory_iterator(), has_mesh)) {
      read_meshes(set, input, request.unit);
      return set;
    }
    set = read_particles_folder(files);
    to_millimetres(set, request.unit.length);
    return set;
  }
  const std::string extension = input.extension().string();
  if (extension == ".h5" || extension == ".json") {
    if (request.unit.length != LengthUnit::millimetre)
      throw InvalidInput(input.string() + ": a model is in mm; give no unit", {{RemedyKind::leave_unit_out}});
    ExchangeSet set = read_model_file(input);
    add_training_shapes(set);
    return set;
  }
  ExchangeSet set;
  if (extension == ".swproj" || extension == ".xlsx")
    set = read_project(input);
  else if (extension == ".tps")
    set = read_tps_file(input);
  else if (extension == ".csv")
    set = read_points(read_landmark_table(input));
  else
    throw InvalidInput(input.string() +
                       ": is none of what can be converted: a model's folder, .h5, .h5.json, a folder of "
                       "corresponding meshes or of .particles, .swproj, .xlsx, .tps, .csv");
  to_millimetres(set, request.unit.length);
  return set;
}

void add_triangles(ExchangeSet& set, const fs::path& mesh) {
  TriangleSoup soup = read_mesh(mesh).soup;
  if (!set.triangles.empty() || set.shapes.empty())
    throw InvalidInput(mesh.string() + ": the input has its own triangles; give no mesh for them",
                       {{RemedyKind::leave_triangles_out}});
  if (soup.points.size() != set.shapes.front().size())
    throw InvalidInput(mesh.string() + ": has " + std::to_string(soup.points.size()) +
                       " vertices, the shapes have " + std::to_string(set.shapes.front().size()) +
                       " points; its vertices must be those points, in their order");
  set.triangles = std::move(soup.triangles);
}

void check_names(const ConvertRequest& request, const ExchangeSet& set) {
  std::vector<std::string> sorted = set.names;
  std::sort(sorted.begin(), sorted.end());
  const auto twin = std::adjacent_find(sorted.begin(), sorted.end());
  if (twin != sorted.end())
    throw InvalidInput(request.input.string() + ": two shapes have the name " + *twin + "; rename one");
  for (std::size_t i = 0; i < set.names.size(); ++i) {
    // A shape's name becomes a file name, so it must not lead to another folder.
    if (set.names[i].empty() || fs::path(set.names[i]).filename() != set.names[i] ||
        set.names[i].front() == '.')
      throw InvalidInput(request.input.string() + ": the name of shape " + std::to_string(i + 1) +
                         " cannot be that of a file; rename it");
    if (set.shapes[i].size() != set.shapes.front().size())
      throw InvalidInput(request.input.string() + ": " + set.names[i] + " has " +
                         std::to_string(set.shapes[i].size()) + " points, " + set.names.front() + " has " +
                         std::to_string(set.shapes.front().size()) +
                         "; corresponding shapes have the same number");
  }
}

// Meshes were checked when they were read.
void check_sizes(const ConvertRequest& request, ExchangeSet& set) {
  SizeCheck sizes(request.unit);
  for (std::size_t i = 0; i < set.shapes.size(); ++i)
    sizes.add(request.input.string() + ": " + set.names[i], set.shapes[i]);
  if (const auto note = sizes.note()) set.notes.push_back(*note);
}

}  // namespace

ExchangeSet read_exchange_set(const ConvertRequest& request) {
  ExchangeSet set = read_by_kind(request);
  const bool only_points = !set.model && set.triangles.empty();
  if (!request.triangles.empty()) add_triangles(set, request.triangles);
  check_names(request, set);
  if (only_points) check_sizes(request, set);
  return set;
}

}  // namespace foramen
