#pragma once
/// \file
/// The mean of shapes that are mapped to one torus, as a template.

#include <span>
#include <vector>

#include "correspond/template_surface.hpp"
#include "foramen/core/options.hpp"
#include "foramen/core/run_context.hpp"
#include "foramen/correspond/registration_frame.hpp"
#include "foramen/correspond/registration_options.hpp"
#include "foramen/model/procrustes.hpp"
#include "sampling/lift_to_surface.hpp"

namespace foramen {

/// Remeshes a surface to `vertices` vertices that are distributed by curvature (remesh()), with their map to
/// the torus.
TemplateSurface remeshed_template(const Mesh& surface, const TorusMap& map, int vertices,
                                  const RunContext& ctx);

/// The mean of the shapes as a template.
struct MeanTemplate {
  TemplateSurface surface;  ///< in the coordinates of the Procrustes mean
  /// Per shape: maps its coordinates to those of the mean (scale 1).
  std::vector<SimilarityTransform> transforms;
  std::vector<Vec3> grid;  ///< the mean at the points of the torus grid, which depends on the lattice only
};

/// Lifts the points of a uniform torus grid to all shapes and computes their Procrustes mean with
/// ScaleMode::keep.
MeanTemplate mean_template(std::span<const TorusLocator* const> shapes, const Lattice& lattice,
                           const RunContext& ctx, const TemplateOptions& options = {});

}  // namespace foramen
