#pragma once
/// \file
/// Projection of new surfaces on a finished model: registration to its mean, projection on its modes, and
/// distances.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "foramen/apply/project_shape.hpp"
#include "foramen/spatial/surface_distance.hpp"
#include "modelfiles/usable_model.hpp"

namespace foramen {

/// The projection of one surface, in the surface's own coordinates, in mm.
struct Projection {
  std::vector<Vec3> landmarks;
  ProjectedShape shape;
  SurfaceDistance representation;    ///< between the surface and the mesh of its landmarks
  SurfaceDistance fit;               ///< between the surface and the mesh of shape.fit
  std::vector<double> residual;      ///< per vertex of the surface: distance to the mesh of shape.fit
  std::vector<double> fit_residual;  ///< per landmark of shape.fit: distance to the surface
  std::vector<std::string> left_out;
  /// Between the surface and the fit of the model without the shapes left out; unset if none is left out.
  std::optional<SurfaceDistance> fit_without_left_out = std::nullopt;
};

/// Projects any number of surfaces on one model. Calls may run in parallel.
class SurfaceProjector {
 public:
  /// Throws TopologyError if the mean cannot be a template.
  SurfaceProjector(UsableModel model, const RunContext& ctx);

  /// Projects a closed surface of genus 1 in any pose, on one thread. \param left_out  training shapes, see
  /// model_without(). Throws as MeanRegistrar::landmarks_on(), and InvalidInput as model_without().
  Projection operator()(const Mesh& surface, std::span<const std::string> left_out,
                        const RunContext& ctx) const;

  /// The model of the training shapes that are not left out. Throws InvalidInput as model_without().
  AlignedModel without(std::span<const std::string> left_out) const;
  const UsableModel& model() const { return model_; }

 private:
  UsableModel model_;
  MeanRegistrar registrar_;
};

/// The projection as numbers: scores_sd; representation and fit (mean_mm, p95_mm, hausdorff_mm); and, if
/// shapes are left out, left_out and fit_without_left_out.
nlohmann::ordered_json projection_json(const Projection& projection);

}  // namespace foramen
