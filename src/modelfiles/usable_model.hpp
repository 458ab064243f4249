#pragma once
/// \file
/// A finished model with everything that is needed to apply it to new surfaces.

#include <filesystem>
#include <string>
#include <vector>

#include "foramen/correspond/mean_registrar.hpp"
#include "foramen/evaluate/generalization.hpp"
#include "foramen/sampling/landmark_mesh.hpp"
#include "modelfiles/model_folder.hpp"

namespace foramen {

struct UsableModel {
  AlignedModel aligned;            ///< the model and its aligned training shapes
  std::vector<std::string> names;  ///< stems of the training shapes
  ScaleMode scale = ScaleMode::keep;
  AnatomicalSpace space = AnatomicalSpace::lps;
  LandmarkMesh landmarks;
  std::vector<Vec2> curvatures;  ///< see Atlas
  Lattice lattice = Lattice::Identity();
};

/// Reads model.h5 and atlas.h5 of a model's folder. Throws IoError, also if the two files belong to different
/// models.
UsableModel read_usable_model(const std::filesystem::path& folder);
/// As read_usable_model(), if model.h5 has already been read.
UsableModel usable_model(LoadedModel loaded, const std::filesystem::path& folder);

/// Makes the registrar that places the model's landmarks on new surfaces. Throws TopologyError if the mean
/// cannot be a template.
MeanRegistrar registrar_of(const UsableModel& model, const RunContext& ctx);

}  // namespace foramen
