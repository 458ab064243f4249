#include <cmath>
#include <set>

#include "exchange/exchange_set.hpp"
#include "foramen/core/error.hpp"
#include "foramen/io/mesh_file.hpp"
#include "io/atomic_file.hpp"
#include "io/named_points.hpp"
#include "io/scalismo_landmarks.hpp"
#include "io/shapeworks_project.hpp"
#include "io/table_file.hpp"
#include "modelfiles/statismo_model.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;

void require_shapes(const ExchangeSet& set, const ConvertRequest& request) {
  if (set.shapes.empty())
    throw InvalidInput(
        request.input.string() +
        ": holds a model without scores of its training shapes, and so no shapes; only a model "
        "(.h5, .h5.json) can be written");
}

void require_triangles(const std::vector<std::array<int, 3>>& triangles) {
  if (triangles.empty())
    throw InvalidInput("the input holds points without triangles; give a mesh whose vertices they are",
                       {{RemedyKind::give_triangles}});
}

std::vector<NamedPoints> named_points(const ExchangeSet& set) {
  std::vector<NamedPoints> points;
  for (std::size_t i = 0; i < set.names.size(); ++i) points.push_back({set.names[i], set.shapes[i]});
  return points;
}

// Throws InvalidInput if the folder holds other shapes, because readers would take them for shapes of this
// set.
void prepare_folder(const fs::path& folder, const std::vector<std::string>& names,
                    const std::string& extension) {
  make_folder(folder);
  const std::set<std::string> known(names.begin(), names.end());
  for (const auto& entry : fs::directory_iterator(folder)) {
    const fs::path file = entry.path().filename();
    if (file.extension() != extension || !known.contains(file.stem().string()))
      throw InvalidInput(folder.string() + ": holds another file, " + file.string() + "; name a new folder");
  }
}

template <class Write>
std::size_t write_folder(const ExchangeSet& set, const fs::path& folder, const std::string& extension,
                         const RunContext& ctx, const Write& write) {
  prepare_folder(folder, set.names, extension);
  for (std::size_t i = 0; i < set.names.size(); ++i) {
    ctx.step("write", static_cast<double>(i) / static_cast<double>(set.names.size()));
    write(folder / (set.names[i] + extension), set.shapes[i]);
  }
  return set.names.size();
}

void write_landmarks(const fs::path& file, const std::vector<Vec3>& shape) {
  std::vector<ScalismoLandmark> landmarks;
  for (std::size_t i = 0; i < shape.size(); ++i) landmarks.push_back({std::to_string(i), shape[i], {}});
  write_scalismo_landmarks(file, landmarks);
}

std::vector<Eigen::Matrix4d> common_transforms(const ExchangeSet& set, ScaleMode scale) {
  if (!set.to_common.empty()) return set.to_common;
  std::vector<Eigen::Matrix4d> transforms;
  for (const SimilarityTransform& transform : procrustes(set.shapes, scale).transforms)
    transforms.push_back(transform.matrix());
  return transforms;
}

// Every particle is a vertex of the groomed mesh. The project is written last, when all files that it names
// exist.
std::size_t write_project(const ExchangeSet& set, const ConvertRequest& request, const RunContext& ctx) {
  require_triangles(set.triangles);
  const auto transforms = common_transforms(set, request.scale);
  const fs::path folder = request.output.parent_path();
  make_folder(folder / "groomed");
  make_folder(folder / "particles");
  std::vector<ShapeWorksSubject> subjects;
  for (std::size_t i = 0; i < set.names.size(); ++i) {
    ctx.step("write", static_cast<double>(i) / static_cast<double>(set.names.size()));
    ShapeWorksSubject subject;
    subject.name = set.names[i];
    subject.shape = subject.groomed = fs::path("groomed") / (subject.name + ".ply");
    subject.local_particles = fs::path("particles") / (subject.name + "_local.particles");
    subject.world_particles = fs::path("particles") / (subject.name + "_world.particles");
    subject.procrustes = transforms[i];
    std::vector<Vec3> world;
    for (const Vec3& p : set.shapes[i]) world.emplace_back((transforms[i] * p.homogeneous()).head<3>());
    write_ply(folder / subject.groomed, {set.shapes[i], set.triangles});
    write_particles(folder / subject.local_particles, set.shapes[i]);
    write_particles(folder / subject.world_particles, world);
    subjects.push_back(std::move(subject));
  }
  write_shapeworks(request.output, subjects, set.shapes.front().size());
  return 3 * set.names.size() + 1;
}

void write_score_table(const fs::path& file, const StatismoModel& model,
                       const std::vector<std::string>& names) {
  std::vector<std::string> header{"shape"};
  for (Eigen::Index m = 0; m < model.scores.rows(); ++m) header.push_back("mode" + std::to_string(m + 1));
  std::vector<Row> rows;
  for (std::size_t i = 0; i < names.size(); ++i) {
    Row row{names[i]};
    for (Eigen::Index m = 0; m < model.scores.rows(); ++m)
      row.emplace_back(model.scores(m, static_cast<Eigen::Index>(i)));
    rows.push_back(std::move(row));
  }
  write_csv(file, header, rows);
}

}  // namespace

StatismoModel model_of(const ExchangeSet& set, ScaleMode scale, const std::string& command) {
  if (set.model) return *set.model;
  require_triangles(set.triangles);
  if (set.shapes.size() < 2) throw InvalidInput("a model needs two shapes or more; the input holds one");
  const ProcrustesResult result = procrustes(set.shapes, scale);
  const ShapeModel model = model_of_aligned(result.aligned, set.triangles);
  if (model.modes() == 0) throw InvalidInput("the shapes do not differ: there is no model of them");
  std::vector<Eigen::VectorXd> aligned;
  for (const auto& shape : result.aligned) aligned.push_back(flattened(shape));
  StatismoModel file = statismo_model(model, aligned, command);
  file.shape_uris = set.names;
  return file;
}

std::size_t write_exchange_set(const ExchangeSet& set, const ConvertRequest& request, ExchangeFormat format,
                               const RunContext& ctx) {
  const bool is_model = format == ExchangeFormat::statismo || format == ExchangeFormat::scalismo_json;
  if (!is_model) require_shapes(set, request);
  if (request.output.has_parent_path()) make_folder(request.output.parent_path());
  switch (format) {
    case ExchangeFormat::statismo:
    case ExchangeFormat::scalismo_json:
      write_statismo(request.output, model_of(set, request.scale, request.command));
      return 1;
    case ExchangeFormat::shapeworks:
      return write_project(set, request, ctx);
    case ExchangeFormat::tps:
      write_tps(request.output, named_points(set));
      return 1;
    case ExchangeFormat::landmark_table:
      write_landmark_table(request.output, named_points(set));
      return 1;
    case ExchangeFormat::score_table:
      write_score_table(request.output, model_of(set, request.scale, request.command), set.names);
      return 1;
    case ExchangeFormat::ply:
      require_triangles(set.triangles);
      return write_folder(set, request.output, ".ply", ctx, [&](const fs::path& file, const auto& shape) {
        write_ply(file, {shape, set.triangles});
      });
    case ExchangeFormat::vtp:
      require_triangles(set.triangles);
      return write_folder(set, request.output, ".vtp", ctx, [&](const fs::path& file, const auto& shape) {
        write_vtp(file, {shape, set.triangles});
      });
    case ExchangeFormat::scalismo_landmarks:
      return write_folder(set, request.output, ".json", ctx, write_landmarks);
  }
  throw InternalError("an exchange format without a writer");
}

}  // namespace foramen
