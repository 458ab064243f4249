#pragma once
/// \file
/// Vertebra-like shapes with known correspondence.

#include <vector>

#include "foramen/core/mesh.hpp"
#include "foramen/core/run_context.hpp"

namespace foramen {

struct SynthOptions {
  int shapes = 14;
  std::uint64_t seed = 1;
  int modes = 4;                    ///< True modes of variation; 0: every shape its own random deformation.
  double amplitude_mm = 3.0;        ///< RMS displacement of a coordinate by the deformation [mm].
  double correlation_mm = 25.0;     ///< Distance over which displacements fade out of step [mm].
  int vertices = 10000;             ///< of a shape, about
};

struct SynthShape {
  TriangleSoup surface;   ///< its own triangulation, shuffled, in a random pose
  TriangleSoup truth;     ///< the common truth mesh carried by the same deformation and pose: identical triangles in all shapes
};

/// A lumbar vertebra with body, canal and processes as an implicit surface, carried by the flow of smooth random
/// velocity fields (so each deformation is a diffeomorphism), every shape triangulated anew. Genus 1, closed, manifold, outward.
/// Item i of n does not depend on n (for modes = 0 and modes > 0 alike).
std::vector<SynthShape> synth_cohort(const SynthOptions& options, const RunContext& ctx);

}  // namespace foramen
