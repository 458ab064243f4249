#pragma once
/// \file
/// The mean of shapes mapped to one torus, as a template.

#include <span>
#include <vector>

#include "correspond/template_surface.hpp"
#include "foramen/core/options.hpp"
#include "foramen/core/run_context.hpp"
#include "foramen/correspond/group_options.hpp"
#include "foramen/correspond/registration_frame.hpp"
#include "foramen/model/procrustes.hpp"
#include "sampling/lift_to_surface.hpp"

namespace foramen {

/// A surface by `vertices` points of it, spread by curvature (remesh()), with their map to the torus.
TemplateSurface remeshed_template(const Mesh& surface, const TorusMap& map, int vertices,
                                  const RunContext& ctx);

struct MeanTemplate {
  TemplateSurface surface;                      ///< in the coordinates of the Procrustes mean
  std::vector<SimilarityTransform> transforms;  ///< per shape: its own coordinates -> the mean's (scale 1)
  std::vector<Vec3> grid;  ///< the mean at the points of the torus grid, always the same for one lattice
};

/// The Procrustes mean (sizes kept) of the shapes lifted from a uniform grid of the torus.
MeanTemplate mean_template(std::span<const TorusLocator* const> shapes, const Lattice& lattice,
                           const RunContext& ctx, const TemplateOptions& options = {});

}  // namespace foramen
