#pragma once
/// \file
/// Where the processes, facets and endplate rims of the template (vertebra_surface()) are.

#include <array>
#include <vector>

#include "foramen/core/mesh.hpp"

namespace foramen::synth {

/// A process of the arch, from its base to its tip [mm].
struct Process {
  Vec3 base, tip;
  double width_mm;  ///< how far from its axis the process reaches, about
};

/// A joint facet.
struct Facet {
  Vec3 centre;
  Vec3 normal;  ///< outward unit vector
  Vec3 along;   ///< unit vector of the plane of the facet, from its base to its tip
};

/// A point of an endplate's rim.
struct RimPoint {
  Vec3 position;
  Vec3 outward;  ///< unit vector in the plane of the endplate
  Vec3 upward;   ///< unit vector out of the body: up for the upper rim and down for the lower one
  double angle;  ///< around the body, 0 at the left and pi / 2 at the back
};

Process spinous_process();
/// The processes of the left side: transverse, superior and inferior articular.
std::array<Process, 3> left_processes();
/// The facets of the left side: superior and inferior.
std::array<Facet, 2> left_facets();
/// Points at equal angles on the upper (`side` = 1) or the lower rim (`side` = -1).
std::vector<RimPoint> endplate_rim(int side, int points);

}  // namespace foramen::synth
