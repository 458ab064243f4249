#pragma once
/// \file
/// A finished model with all that is needed to use it on new surfaces.

#include <filesystem>
#include <string>
#include <vector>

#include "foramen/correspond/mean_registrar.hpp"
#include "foramen/evaluate/generalization.hpp"
#include "foramen/sampling/landmark_mesh.hpp"
#include "modelfiles/atlas_file.hpp"
#include "modelfiles/model_folder.hpp"

namespace foramen {

struct UsableModel {
  AlignedModel aligned;            ///< the training shapes as the model has them, and the model
  std::vector<std::string> names;  ///< stems of the training shapes
  ScaleMode scale = ScaleMode::keep;
  AnatomicalSpace space = AnatomicalSpace::lps;
  LandmarkMesh landmarks;
  Lattice lattice = Lattice::Identity();
};

/// Reads model.h5 and atlas.h5 of a model's folder. Throws IoError; also if the two are not of one model.
UsableModel read_usable_model(const std::filesystem::path& folder);
/// The same where model.h5 has been read.
UsableModel usable_model(LoadedModel loaded, const std::filesystem::path& folder);

/// For surfaces that are to get the model's landmarks. Throws TopologyError if the mean cannot be a template.
MeanRegistrar registrar_of(const UsableModel& model, const RunContext& ctx);

}  // namespace foramen
