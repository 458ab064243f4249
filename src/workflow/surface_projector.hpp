#pragma once
/// \file
/// What a finished model says of new surfaces: registered to its mean, projected on its modes, compared.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "foramen/apply/project_shape.hpp"
#include "foramen/spatial/surface_distance.hpp"
#include "modelfiles/usable_model.hpp"

namespace foramen {

/// One surface, in its own coordinates, mm.
struct Projection {
  std::vector<Vec3> landmarks;
  ProjectedShape shape;
  SurfaceDistance representation;    ///< of the surface to its landmarks' mesh
  SurfaceDistance fit;               ///< of the surface to shape.fit
  std::vector<double> residual;      ///< per vertex of the surface: distance to the mesh of shape.fit
  std::vector<double> fit_residual;  ///< per landmark of shape.fit: distance to the surface
  std::vector<std::string> left_out;
  /// Of the surface to the fit of the model without those; unset: none is left out.
  std::optional<SurfaceDistance> fit_without_left_out = std::nullopt;
};

/// Made once, for any number of surfaces; const calls may run in parallel.
class SurfaceProjector {
 public:
  /// Throws TopologyError if the mean cannot be a template.
  SurfaceProjector(UsableModel model, const RunContext& ctx);

  /// Of a closed surface of genus 1 in any pose. On one thread. \param left_out  training shapes, see
  /// model_without()  Throws as MeanRegistrar::landmarks_on(), and InvalidInput as model_without().
  Projection operator()(const Mesh& surface, std::span<const std::string> left_out,
                        const RunContext& ctx) const;

  /// The model of the other shapes. Throws InvalidInput as model_without().
  AlignedModel without(std::span<const std::string> left_out) const;
  const UsableModel& model() const { return model_; }

 private:
  UsableModel model_;
  MeanRegistrar registrar_;
};

/// In numbers: scores_sd; representation and fit (mean_mm, p95_mm, hausdorff_mm); left_out and
/// fit_without_left_out if shapes are left out.
nlohmann::ordered_json projection_json(const Projection& projection);

}  // namespace foramen
