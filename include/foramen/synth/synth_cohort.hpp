#pragma once
/// \file
/// Vertebra-like shapes with known correspondence.

#include <cstdint>
#include <vector>

#include "foramen/core/mesh.hpp"
#include "foramen/core/options.hpp"
#include "foramen/core/run_context.hpp"

namespace foramen {

/// The defaults are frozen, and so is what they give: published figures name a cohort by its seed alone, and
/// other shapes under the same seed would make them incomparable. A test holds checksums of seeds 101 to 105.
struct SynthOptions {
  int shapes = 14;         ///< >= 1
  std::uint64_t seed = 1;  ///< of the cohort; every item has streams of its own, forked from it
  int modes = 4;  ///< True modes of variation, of variances ~ 1/k; 0: every shape its own random deformation.
  /// RMS displacement of a coordinate by the deformation, to first order, over the ensemble [mm]. >= 0. With
  /// the default amplitude and correlation, closest normal-compatible points after rigid alignment by the
  /// truth miss the true correspondence by about 1.8 mm on average, p95 3.9 mm for modes = 0 and 4.6 mm for
  /// modes = 4.
  double amplitude_mm = 2.1;
  /// Displacements at distance r are correlated by exp(-r^2 / (2 correlation_mm^2)) [mm]. > 0.
  double correlation_mm = 40.0;
  int vertices =
      10000;  ///< of a shape, within 5 %; at least 1500, since larger triangles would bridge thin processes
};

template <class Visitor>
void describe(Visitor& visit, MaybeConst<SynthOptions> auto& o) {
  visit(o.shapes, {.name = "shapes", .range = at_least(1).up_to(100000), .meaning = "number of shapes"});
  visit(o.seed, {.name = "seed", .meaning = "seed of all random numbers"});
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

struct SynthShape {
  TriangleSoup surface;  ///< its own triangulation, shuffled, in a random pose
  TriangleSoup truth;    ///< the common truth mesh carried by the same deformation and pose: identical
                         ///< triangles in all shapes
};

/// A lumbar vertebra with body, canal and processes as an implicit surface (vertebra_surface), carried by the
/// flow of smooth random velocity fields (so each deformation is a diffeomorphism), every shape triangulated
/// anew. Genus 1, closed, manifold, outward.
///
/// The field of item i is \f$ v_i = \sum_k b_{ik} V_k \f$, with \f$ b_{ik} \sim N(0, \sigma_k^2) \f$,
/// \f$ \sigma_k^2 \propto 1/k \f$, \f$ \sum_k \sigma_k^2 \f$ = amplitude^2 and V_k fields of the cohort;
/// without modes it is amplitude times a field of its own. The pose is any rotation and a translation within
/// +-200 mm in each coordinate. Item i of n does not depend on n (for modes = 0 and modes > 0 alike), nor
/// anything on the number of threads. Throws InvalidInput for options out of range.
std::vector<SynthShape> synth_cohort(const SynthOptions& options, const RunContext& ctx);

}  // namespace foramen
