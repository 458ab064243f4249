#pragma once
/// \file
/// The files of a model: what a build writes and what other commands read back.

#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "foramen/io/mesh_file.hpp"
#include "modelfiles/build_record.hpp"

namespace foramen {

struct LoadedModel {
  ShapeModel model;
  std::vector<std::string> names;  ///< stems of the training shapes
  Eigen::MatrixXd scores;          ///< modes x shapes, in standard deviations
  AnatomicalSpace space = AnatomicalSpace::lps;
};

/// Reads MODEL/model.h5 (or a model.h5 itself). Throws IoError.
LoadedModel load_model(const std::filesystem::path& path);

/// What load_model() gives of the model that write_model_files() writes of a build.
LoadedModel loaded_as_written(const BuildRecord& record, const std::string& command);

/// Scores of the training shapes, modes x shapes, in standard deviations.
Eigen::MatrixXd training_scores(const AlignedModel& aligned);

/// mean.ply, model.h5, corresponding/, modes/, atlas.h5, scores.csv; each whole or not at all. `command` is
/// recorded. The corresponding meshes are divided by `millimetres` per unit, back to the units of the input
/// files.
void write_model_files(const std::filesystem::path& folder, const BuildRecord& record,
                       const std::string& command, double millimetres);

/// modeNN_minus2sd.ply and modeNN_plus2sd.ply for every mode.
void write_modes(const std::filesystem::path& folder, const ShapeModel& model, double sd,
                 AnatomicalSpace space);

/// SOURCE_DATE_EPOCH as an ISO 8601 time in UTC, or the epoch.
std::string build_time();

}  // namespace foramen
