#pragma once
/// \file
/// Synthetic cohorts of vertebra-like shapes with known correspondence.

#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "foramen/core/mesh.hpp"
#include "foramen/core/options.hpp"
#include "foramen/core/run_context.hpp"

namespace foramen {

/// How the shapes of a cohort differ from the template.
enum class SynthDeformation {
  smooth,  ///< a smooth random deformation, and surfaces of one density without noise
  /// The smooth deformation, and before it what registration by smooth deformations cannot foresee: random
  /// deformations with correlation lengths of 16, 8 and 4 mm, growth and tilt of single processes, endplate
  /// rims and facets that move by laws of their own, and spurs. Left and right are correlated. The surfaces
  /// have different numbers of vertices and the noise of a segmentation.
  rough,
};
template <>
struct EnumWords<SynthDeformation> {
  static constexpr std::pair<std::string_view, SynthDeformation> all[] = {
      {"smooth", SynthDeformation::smooth}, {"rough", SynthDeformation::rough}};
};

/// The defaults and the shapes that they give must not change: published results identify a cohort by its
/// seed alone, so they would not be comparable with new ones. The same holds for rough cohorts. A test
/// checks checksums of smooth and of rough cohorts.
struct SynthOptions {
  int shapes = 14;         ///< >= 1
  std::uint64_t seed = 1;  ///< seed of the cohort; each item has its own random streams, forked from it
  SynthDeformation deformation = SynthDeformation::smooth;
  /// The next three options describe the smooth deformation, which a rough cohort has too.
  ///
  /// Number of true modes of variation, with variances proportional to 1/k; 0: each shape has an
  /// independent random deformation.
  int modes = 4;
  /// RMS displacement of a coordinate over the ensemble, to first order [mm]. >= 0. This sets the
  /// difficulty: with the default amplitude and correlation, the closest points with compatible normals
  /// after rigid alignment by the truth differ from the true corresponding points by about 1.8 mm on
  /// average (95th percentile 3.9 mm for modes = 0 and 4.6 mm for modes = 4).
  double amplitude_mm = 2.1;
  /// Displacements at distance r are correlated by exp(-r^2 / (2 correlation_mm^2)) [mm]. > 0.
  double correlation_mm = 40.0;
  /// Vertices per shape, within 5 %; at least 1500, since larger triangles would bridge thin processes. The
  /// shapes of a rough cohort have 0.6 to 1.6 times as many, but not fewer than 1500.
  int vertices = 10000;
};

template <class Visitor>
void describe(Visitor& visit, MaybeConst<SynthOptions> auto& o) {
  visit(o.shapes, {.name = "shapes", .range = at_least(1).up_to(100000), .meaning = "number of shapes"});
  visit(o.seed, {.name = "seed", .meaning = "seed of all random numbers"});
  visit(o.deformation, {.name = "deformation",
                        .meaning = "smooth alone, or rough: also fine scales, features that move by their "
                                   "own laws, spurs, noise and mixed densities"});
  visit(o.modes, {.name = "modes",
                  .range = at_least(0).up_to(1000),
                  .meaning = "true modes of variation; 0: every shape its own deformation"});
  visit(o.amplitude_mm, {.name = "amplitude",
                         .unit = "mm",
                         .range = at_least(0).up_to(20),
                         .meaning = "RMS displacement of a coordinate"});
  visit(o.correlation_mm, {.name = "correlation",
                           .unit = "mm",
                           .range = at_least(5).up_to(500),
                           .meaning = "correlation length of the displacement"});
  visit(
      o.vertices,
      {.name = "vertices", .range = at_least(1500).up_to(1000000), .meaning = "vertices of a shape, about"});
}

/// A synthetic shape and its true correspondence.
struct SynthShape {
  TriangleSoup surface;  ///< the surface with its own triangulation, in random order and pose
  /// A common template mesh with the same deformation and pose as the surface, without its noise; its
  /// triangles are the same for all shapes.
  TriangleSoup truth;
};

/// Makes a cohort from a template, a lumbar vertebra given as an implicit surface (vertebra_surface()).
/// Each shape is triangulated independently and deformed by the flow of a smooth random velocity field,
/// which is a diffeomorphism. In a rough cohort other flows come before it (SynthDeformation::rough). All
/// surfaces are closed manifolds of genus 1, wound outward.
///
/// The field of item i is \f$ v_i = \sum_k b_{ik} V_k \f$, with \f$ b_{ik} \sim N(0, \sigma_k^2) \f$, \f$
/// \sigma_k^2 \propto 1/k \f$, \f$ \sum_k \sigma_k^2 \f$ = amplitude^2 and V_k fields of the cohort; without
/// modes it is the amplitude times an independent field. The pose is a uniformly distributed rotation and a
/// translation within +-200 mm in each coordinate. Item i does not depend on the number of shapes, and
/// nothing depends on the number of threads. Throws InvalidInput for options out of range.
std::vector<SynthShape> synth_cohort(const SynthOptions& options, const RunContext& ctx);

}  // namespace foramen
