#include "modelfiles/model_folder.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <utility>

#include "foramen/core/error.hpp"
#include "foramen/io/statismo_file.hpp"
#include "io/atomic_file.hpp"
#include "io/table_file.hpp"
#include "modelfiles/atlas.hpp"
#include "modelfiles/atlas_file.hpp"
#include "modelfiles/statismo_model.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;

// For example "mode01_minus2sd": the mode has two digits, the number of standard deviations no trailing
// zeros.
std::string mode_file(int mode, double sd) {
  char text[64];
  std::snprintf(text, sizeof text, "mode%02d_%s%gsd.ply", mode + 1, sd < 0 ? "minus" : "plus", std::abs(sd));
  return text;
}

/// The shapes with these scores, which are in standard deviations.
std::vector<Eigen::VectorXd> shapes_of(const ShapeModel& model, const Eigen::MatrixXd& scores) {
  std::vector<Eigen::VectorXd> shapes;
  shapes.reserve(scores.cols());
  for (Eigen::Index i = 0; i < scores.cols(); ++i)
    shapes.push_back(model.reconstruct(scores.col(i).cwiseProduct(model.variance().cwiseSqrt())));
  return shapes;
}

std::vector<Eigen::VectorXd> aligned_shapes(const AlignedModel& aligned) {
  std::vector<Eigen::VectorXd> shapes;
  shapes.reserve(aligned.alignment.aligned.size());
  for (const auto& landmarks : aligned.alignment.aligned) shapes.push_back(flattened(landmarks));
  return shapes;
}

StatismoModel file_of(const BuildRecord& record, const std::string& command) {
  const AlignedModel& aligned = record.built.aligned;
  StatismoModel file = statismo_model(aligned.model, aligned_shapes(aligned), command);
  for (const InputShape& input : record.inputs) file.shape_uris.push_back(source_of(input));
  return file;
}

void write_scores(const fs::path& path, const BuildRecord& record) {
  const int modes = record.built.aligned.model.modes();
  std::vector<std::string> header{"shape"};
  for (int m = 0; m < modes; ++m) header.push_back("mode" + std::to_string(m + 1));
  const Eigen::MatrixXd scores = training_scores(record.built.aligned);
  std::vector<Row> rows;
  for (std::size_t i = 0; i < record.inputs.size(); ++i) {
    Row row{record.inputs[i].stem};
    for (int m = 0; m < modes; ++m) row.emplace_back(scores(m, static_cast<int>(i)));
    rows.push_back(std::move(row));
  }
  write_csv(path, header, rows);
}

LoadedModel loaded(StatismoModel file, AnatomicalSpace space) {
  LoadedModel loaded{.model = ShapeModel(std::move(file.mean), std::move(file.basis),
                                         std::move(file.variance), std::move(file.triangles)),
                     .names = {},
                     .scores = std::move(file.scores),
                     .space = space,
                     .notes = std::move(file.notes)};
  for (const std::string& uri : file.shape_uris) loaded.names.push_back(fs::path(uri).stem().string());
  if (!file.landmark_weights.empty()) {
    const std::vector<Eigen::VectorXd> shapes = shapes_of(loaded.model, loaded.scores);
    loaded.model = reweighted(loaded.model, std::move(file.landmark_weights));
    loaded.scores = scores_of(loaded.model, shapes);
  }
  return loaded;
}

// The reference's: its coordinates are the model's.
AnatomicalSpace space_of(const BuildRecord& record) {
  return record.inputs[record.built.registration.reference].space;
}

}  // namespace

std::string build_time() {
  const char* epoch = std::getenv("SOURCE_DATE_EPOCH");
  const std::time_t seconds = epoch ? static_cast<std::time_t>(std::atoll(epoch)) : 0;
  std::tm utc{};
  gmtime_r(&seconds, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

LoadedModel load_model(const fs::path& path) {
  const fs::path file = fs::is_directory(path) ? path / "model.h5" : path;
  if (!fs::exists(file))
    throw IoError(file.string() + ": there is no such model; build it", {{RemedyKind::build_model}});
  const fs::path mean = file.parent_path() / "mean.ply";
  StatismoModel model = read_statismo(file);
  return loaded(std::move(model), fs::exists(mean) ? read_mesh(mean).space.value_or(AnatomicalSpace::lps)
                                                   : AnatomicalSpace::lps);
}

LoadedModel loaded_as_written(const BuildRecord& record, const std::string& command) {
  return loaded(in_single_precision(file_of(record, command)), space_of(record));
}

Eigen::MatrixXd training_scores(const AlignedModel& aligned) {
  return scores_of(aligned.model, aligned_shapes(aligned));
}

void write_modes(const fs::path& folder, const ShapeModel& model, double sd, AnatomicalSpace space) {
  make_folder(folder);
  for (int m = 0; m < model.modes(); ++m)
    for (double sign : {-1.0, 1.0})
      write_ply(folder / mode_file(m, sign * sd),
                {unflattened(model.along_mode(m, sign * sd)), model.triangles()}, space);
}

void write_model_files(const fs::path& folder, const BuildRecord& record, const std::string& command,
                       double millimetres) {
  const BuiltModel& built = record.built;
  const auto& triangles = built.landmarks.mesh.triangles;
  make_folder(folder / "corresponding");
  for (std::size_t i = 0; i < record.inputs.size(); ++i) {
    const InputShape& input = record.inputs[i];
    TriangleSoup soup{built.landmarks.points[i], triangles};
    for (Vec3& p : soup.points) p /= millimetres;
    write_ply(folder / "corresponding" / (input.stem + ".ply"), soup, input.space);
  }
  const ShapeModel& model = built.aligned.model;
  const AnatomicalSpace space = space_of(record);
  write_ply(folder / "mean.ply", {unflattened(model.mean()), triangles}, space);
  write_modes(folder / "modes", model, 2, space);
  write_scores(folder / "scores.csv", record);
  write_statismo(folder / "model.h5", file_of(record, command));
  write_atlas(folder / "atlas.h5", atlas_of(built));
}

}  // namespace foramen
