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

/// Where a label is.
struct LabelExtent {
  std::array<int, 3> low{}, high{};  ///< first and last voxel along i, j, k
  std::int64_t voxels = 0;
};

/// All labels but the background.
std::map<int, LabelExtent> find_labels(const LabelMap& map);

struct ExtractOptions {
  bool keep_cut = false;  ///< Also take a label that reaches the border of the label map, closed flat there.
  /// Of smoothing. >= 0; 0 leaves the voxels' surface with its corners cut. More make wide flat steps
  /// smoother and move the surface farther from the voxels.
  int smoothing_rounds = 15;
  /// No vertex moves farther from its place on the voxels' surface, the middle of a voxel's face, than this,
  /// in voxels: |(dx / sx, dy / sy, dz / sz)| <= bound for spacings s along the lattice. 0 < bound <= 0.5. It
  /// is lowered by tenths of itself while the 95th percentile of the deviation is above half a voxel.
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

/// What voxels that touch along an edge alone are taken for. The voxels do not say, and the genus depends on
/// it.
enum class EdgeContact { joined, apart };

struct ExtractionReport {
  int genus = 0;
  EdgeContact contact = EdgeContact::joined;
  int components = 0;              ///< of the label's voxels; the largest was taken
  std::int64_t voxels = 0;         ///< enclosed: of the largest component and its cavities
  std::int64_t lost_voxels = 0;    ///< of the other components
  std::int64_t filled_voxels = 0;  ///< of cavities
  /// Sides of the label map that it reaches, e.g. "superior"; with keep_cut.
  std::vector<std::string> cut_at;
  double voxel_volume = 0;       ///< enclosed, mm^3
  double volume = 0;             ///< within the surface, mm^3
  SurfaceDistance deviation_mm;  ///< of the surface and the voxels' boundary; mm
  SurfaceDistance deviation;     ///< the same where every voxel is a unit cube: in voxels
  double bound = 0;              ///< that was kept, in voxels
  int restrained = 0;  ///< vertices that smoothing moved less, since the surface would have met itself
};

struct ExtractedSurface {
  TriangleSoup surface;  ///< closed, manifold, one component, wound outward, no self-intersections; LPS mm
  ExtractionReport report;
};

/// Of the label's voxels the largest component is taken and its cavities are filled. Where voxels touch along
/// an edge alone they are taken as joined (18 neighbours; 6 outside), and if the surface then has not genus
/// 1, as apart (6; 18 outside); of both surfaces the one whose genus is nearer to 1 is returned (the first of
/// equals).
///
/// The surface is that of marching cubes \cite lorensen1987 with a vertex in the middle of every face between
/// inside and outside, closed and manifold for any voxels. Its steps are smoothed away by rounds of gradient
/// descent on the bending energy sum_i |u_i|^2, u_i the mean of vertex i's neighbours minus the vertex, after
/// each of which vertices are put back into their ball (bound_voxels, after \cite gibson1998); then it is
/// moved along its normals until it encloses the volume of the voxels; and where it meets itself, vertices
/// are moved back towards where they began. The result does not depend on the order and direction in which
/// the map stores its axes.
///
/// \param extent  of that label, by find_labels()
///
/// Throws InvalidInput: the label reaches the border of the map (and not keep_cut), options out of range, a
/// surface of more than 20 million vertices.
ExtractedSurface extract_label(const LabelMap& map, int label, const LabelExtent& extent,
                               const ExtractOptions& options = {});

}  // namespace foramen
