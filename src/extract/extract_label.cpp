#include "foramen/extract/extract_label.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "extract/binary_volume.hpp"
#include "extract/smooth_surface.hpp"
#include "extract/voxel_surface.hpp"
#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"

namespace foramen {
namespace {

using extract::BinaryVolume;

// The voxels of a label and their surface under one interpretation of contacts along edges.
struct Reading {
  BinaryVolume volume;
  extract::Cleaning cleaning;
  EdgeContact contact = EdgeContact::joined;
  TriangleSoup surface;  // in voxel coordinates, not smoothed
  int genus = 0;
};

Reading read_voxels(const BinaryVolume& voxels, EdgeContact contact) {
  Reading reading;
  reading.volume = voxels;
  reading.contact = contact;
  reading.cleaning = keep_largest_component(reading.volume, contact);
  reading.surface = voxel_surface(reading.volume, contact);
  // On a closed surface every triangle has three half-edges, so V - E + F = V - F / 2.
  const auto euler = std::ssize(reading.surface.points) - std::ssize(reading.surface.triangles) / 2;
  reading.genus = static_cast<int>((2 - euler) / 2);
  return reading;
}

// The interpretation whose genus is nearer to 1, that of a vertebra.
Reading best_reading(const BinaryVolume& voxels, bool keep_cut) {
  Reading joined = read_voxels(voxels, EdgeContact::joined);
  const auto is_cut = [&](const Reading& r) { return !r.cleaning.cut_at.empty() && !keep_cut; };
  if (is_cut(joined)) {
    std::string sides;
    for (const std::string& side : joined.cleaning.cut_at) sides += (sides.empty() ? "" : ", ") + side;
    throw InvalidInput("it reaches the border of the label map (" + sides +
                           "), so the vertebra is cut off; do without it, or take it as it is",
                       {{RemedyKind::keep_cut}});
  }
  if (joined.genus == 1) return joined;
  Reading apart = read_voxels(voxels, EdgeContact::apart);
  const bool nearer = std::abs(apart.genus - 1) < std::abs(joined.genus - 1);
  return nearer && !is_cut(apart) ? apart : joined;
}

// Distances between the surface and the boundary of the voxels, both in coordinates along the axes of the
// lattice.
SurfaceDistance deviation(TriangleSoup surface, TriangleSoup boundary, const Vec3& surface_scale,
                          const Vec3& boundary_scale) {
  for (Vec3& p : surface.points) p = p.cwiseProduct(surface_scale);
  for (Vec3& p : boundary.points) p = p.cwiseProduct(boundary_scale);
  return surface_distance(TriangleTree(build_mesh(std::move(surface))),
                          TriangleTree(build_mesh(std::move(boundary))));
}

ExtractionReport report_on(const Reading& reading) {
  const extract::Cleaning& cleaning = reading.cleaning;
  ExtractionReport report;
  report.genus = reading.genus;
  report.contact = reading.contact;
  report.components = cleaning.components;
  report.voxels = cleaning.kept_voxels + cleaning.filled_voxels;
  report.lost_voxels = cleaning.lost_voxels;
  report.filled_voxels = cleaning.filled_voxels;
  report.cut_at = cleaning.cut_at;
  report.voxel_volume = static_cast<double>(report.voxels) * reading.volume.spacing().prod();
  return report;
}

// Converts the surface from voxel coordinates to mm along the axes of the lattice, smooths it and measures
// its deviation. If the label map was upsampled to blocks of equal voxels, most vertices reach the bound of
// smoothing; the bound is lowered then.
void smooth(ExtractedSurface& result, const Reading& reading, const ExtractOptions& options) {
  constexpr double accepted_p95 = 0.5, lowered = 0.9;
  const Vec3 spacing = reading.volume.spacing();
  const TriangleSoup boundary = voxel_boundary(reading.volume);
  TriangleSoup start = reading.surface;
  for (Vec3& p : start.points) p = p.cwiseProduct(spacing);
  ExtractionReport& report = result.report;
  for (double bound = options.bound_voxels;; bound *= lowered) {
    extract::SmoothedSurface smoothed =
        extract::smooth_surface(start, spacing, report.voxel_volume, options.smoothing_rounds, bound);
    result.surface.points = std::move(smoothed.points);
    report.restrained = smoothed.restrained;
    report.bound = bound;
    report.deviation = deviation(result.surface, boundary, spacing.cwiseInverse(), Vec3::Ones());
    if (report.deviation.p95 <= accepted_p95 || options.smoothing_rounds == 0) break;
  }
  report.deviation_mm = deviation(result.surface, boundary, Vec3::Ones(), spacing);
  report.volume = signed_volume(build_mesh(result.surface));
}

}  // namespace

std::map<int, LabelExtent> find_labels(const LabelMap& map) {
  std::map<int, LabelExtent> found;
  for (int k = 0; k < map.size[2]; ++k)
    for (int j = 0; j < map.size[1]; ++j) {
      LabelExtent* extent = nullptr;
      int of = 0;
      for (int i = 0; i < map.size[0]; ++i) {
        const int label = map.at(i, j, k);
        if (label == 0) continue;
        if (!extent || label != of) {
          const auto [place, is_new] = found.try_emplace(label, LabelExtent{{i, j, k}, {i, j, k}, 0});
          extent = &place->second;
          of = label;
        }
        const std::array<int, 3> at{i, j, k};
        for (std::size_t a = 0; a < 3; ++a) {
          extent->low[a] = std::min(extent->low[a], at[a]);
          extent->high[a] = std::max(extent->high[a], at[a]);
        }
        ++extent->voxels;
      }
    }
  return found;
}

ExtractedSurface extract_label(const LabelMap& map, int label, const LabelExtent& extent,
                               const ExtractOptions& options) {
  check_options("extract_label", options);
  if (extent.voxels <= 0) throw InvalidInput("the label map has no label " + std::to_string(label));
  const Reading reading = best_reading(extract::binary_volume(map, label, extent), options.keep_cut);
  const BinaryVolume& volume = reading.volume;
  const Vec3 spacing = volume.spacing();
  ExtractedSurface result{reading.surface, report_on(reading)};
  smooth(result, reading, options);

  TriangleSoup& surface = result.surface;
  for (Vec3& p : surface.points) p = volume.origin + volume.axes * p.cwiseQuotient(spacing);
  if (volume.axes.determinant() < 0)
    for (auto& t : surface.triangles) std::swap(t[1], t[2]);
  return result;
}

}  // namespace foramen
