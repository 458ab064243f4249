#pragma once
/// \file
/// The files of a model, which a build writes and other commands read.

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
  std::vector<Message> notes = {};  ///< on how the file was read
};

/// Reads MODEL/model.h5 (or a model.h5 itself). Throws IoError.
LoadedModel load_model(const std::filesystem::path& path);

/// What load_model() gives of the model that write_model_files() writes of a build.
LoadedModel loaded_as_written(const BuildRecord& record, const std::string& command);

/// Scores of the training shapes, modes x shapes, in standard deviations.
Eigen::MatrixXd training_scores(const AlignedModel& aligned);

/// Writes mean.ply, model.h5, corresponding/, modes/, atlas.h5 and scores.csv, each whole or not at all.
/// `command` is recorded in model.h5. The coordinates of the corresponding meshes are divided by
/// `millimetres`, the length of one unit of the input files, so that the meshes have the unit of these files.
void write_model_files(const std::filesystem::path& folder, const BuildRecord& record,
                       const std::string& command, double millimetres);

/// Writes two meshes per mode, named modeNN_minus2sd.ply and modeNN_plus2sd.ply for sd = 2.
void write_modes(const std::filesystem::path& folder, const ShapeModel& model, double sd,
                 AnatomicalSpace space);

/// The time in the environment variable SOURCE_DATE_EPOCH, as ISO 8601 in UTC; 1970-01-01 if it is unset.
std::string build_time();

}  // namespace foramen
