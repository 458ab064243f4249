#pragma once
/// \file
/// The surface of one label of a label map.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "foramen/core/options.hpp"
#include "foramen/io/label_map.hpp"
#include "foramen/spatial/surface_distance.hpp"

namespace foramen {

/// The extent of a label in a label map.
struct LabelExtent {
  std::array<int, 3> low{}, high{};  ///< first and last voxel along i, j, k
  std::int64_t voxels = 0;
};

/// All labels but the background.
std::map<int, LabelExtent> find_labels(const LabelMap& map);

struct ExtractOptions {
  /// Also accepts a label that reaches the border of the label map; its surface is closed by a plane there.
  bool keep_cut = false;
  /// Rounds of smoothing. >= 0; 0 leaves the surface of marching cubes. More rounds remove wider flat steps
  /// and move the surface farther from the voxels.
  int smoothing_rounds = 15;
  /// Bound of the displacement of a vertex from its initial position, the centre of a voxel face, in voxels:
  /// |(dx / sx, dy / sy, dz / sz)| <= bound for the voxel spacings s. 0 < bound <= 0.5. The bound is
  /// multiplied by 0.9 as long as the 95th percentile of the deviation exceeds half a voxel.
  double bound_voxels = 0.5;
};
template <class Visitor>
void describe(Visitor& visit, MaybeConst<ExtractOptions> auto& o) {
  visit(o.keep_cut,
        {.name = "keep_cut",
         .meaning = "also take labels that reach the border of the label map, closed flat there"});
  visit(o.smoothing_rounds, {.name = "smoothing_rounds",
                             .range = at_least(0),
                             .meaning = "rounds in which the steps of the voxels are smoothed"});
  visit(o.bound_voxels, {.name = "bound",
                         .unit = "voxels",
                         .range = above(0).up_to(0.5),
                         .meaning = "how far a vertex may move from its place on the voxels' surface"});
}

/// Whether two voxels that share an edge but no face are connected. The label map does not determine this,
/// and the genus of the surface depends on it.
enum class EdgeContact { joined, apart };

/// How a surface was extracted and how far it deviates from the voxels.
struct ExtractionReport {
  int genus = 0;
  EdgeContact contact = EdgeContact::joined;
  int components = 0;            ///< connected components of the label's voxels; the largest one is extracted
  std::int64_t voxels = 0;       ///< enclosed voxels: the largest component and its cavities
  std::int64_t lost_voxels = 0;  ///< voxels of the other components
  std::int64_t filled_voxels = 0;  ///< voxels of cavities
  /// With keep_cut: the sides of the label map that the label reaches, e.g. "superior".
  std::vector<std::string> cut_at;
  double voxel_volume = 0;       ///< volume of the enclosed voxels, mm^3
  double volume = 0;             ///< volume enclosed by the surface, mm^3
  SurfaceDistance deviation_mm;  ///< distances between the surface and the boundary of the voxels, mm
  SurfaceDistance deviation;     ///< the same in voxels, that is, with every voxel as a unit cube
  double bound = 0;              ///< the bound of displacements that was used, in voxels
  int restrained = 0;            ///< vertices that were moved back, because the surface intersected itself
};

/// The surface of a label.
struct ExtractedSurface {
  TriangleSoup surface;  ///< closed, manifold, one component, wound outward, no self-intersections; LPS mm
  ExtractionReport report;
};

/// Extracts the surface of the largest connected component of a label, with cavities filled. First, voxels
/// that share an edge are taken as connected (EdgeContact::joined: 18 neighbours inside, 6 outside). If the
/// surface does not have genus 1, they are also taken as separate (EdgeContact::apart: 6 inside, 18 outside),
/// and the surface whose genus is nearer to 1 is returned (the first if both are equally near).
///
/// The initial surface is that of marching cubes \cite lorensen1987 with a vertex in the middle of every
/// voxel face between inside and outside; it is closed and manifold for any voxels. Its steps are smoothed by
/// gradient descent on the bending energy sum_i |u_i|^2, where u_i is the mean of the neighbours of vertex i
/// minus the vertex. After each round vertices are moved back into the ball of bound_voxels around their
/// initial positions (after \cite gibson1998). Then the surface is moved along its normals until it encloses
/// the volume of the voxels. Where it intersects itself, vertices are moved back towards their initial
/// positions. The result does not depend on the order and direction in which the map stores its axes.
///
/// \param extent  extent of this label, from find_labels()
///
/// Throws InvalidInput if the label reaches the border of the map without keep_cut, if options are out of
/// range, and for a surface of more than 20 million vertices.
ExtractedSurface extract_label(const LabelMap& map, int label, const LabelExtent& extent,
                               const ExtractOptions& options = {});

}  // namespace foramen
