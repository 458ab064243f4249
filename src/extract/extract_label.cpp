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

// The label's voxels under one reading of contacts along edges.
struct Reading {
  BinaryVolume volume;
  extract::Cleaning cleaning;
  EdgeContact contact = EdgeContact::joined;
  TriangleSoup surface;  // in voxel coordinates
  int genus = 0;
};

Reading read_voxels(const BinaryVolume& voxels, EdgeContact contact, bool keep_cut) {
  Reading reading;
  reading.volume = voxels;
  reading.contact = contact;
  reading.cleaning = keep_largest_component(reading.volume, contact);
  if (!reading.cleaning.cut_at.empty() && !keep_cut) {
    std::string sides;
    for (const std::string& side : reading.cleaning.cut_at) sides += (sides.empty() ? "" : ", ") + side;
    throw InvalidInput("it reaches the border of the label map (" + sides +
                       "), so the vertebra is cut off; leave it out, or take it as it is with --keep-cut");
  }
  reading.surface = voxel_surface(reading.volume, contact);
  // Closed, so that every triangle has three halves of an edge: V - E + F = V - F / 2.
  const auto euler = std::ssize(reading.surface.points) - std::ssize(reading.surface.triangles) / 2;
  reading.genus = static_cast<int>((2 - euler) / 2);
  return reading;
}

// Distances of the surface (vertices along the lattice's axes) and the voxels' boundary.
SurfaceDistance deviation(TriangleSoup surface, TriangleSoup boundary, const Vec3& surface_scale,
                          const Vec3& boundary_scale) {
  for (Vec3& p : surface.points) p = p.cwiseProduct(surface_scale);
  for (Vec3& p : boundary.points) p = p.cwiseProduct(boundary_scale);
  return surface_distance(TriangleTree(build_mesh(std::move(surface))),
                          TriangleTree(build_mesh(std::move(boundary))));
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
  constexpr double largest_bound = 0.5;
  if (options.smoothing_rounds < 0 || !(options.bound_voxels > 0 && options.bound_voxels <= largest_bound))
    throw InvalidInput("smoothing needs at least 0 rounds and a bound above 0 and up to 0.5 voxels");
  if (extent.voxels <= 0) throw InvalidInput("the label map has no label " + std::to_string(label));
  const BinaryVolume voxels = extract::binary_volume(map, label, extent);
  Reading reading = read_voxels(voxels, EdgeContact::joined, options.keep_cut);
  if (reading.genus != 1) {
    Reading apart = read_voxels(voxels, EdgeContact::apart, options.keep_cut);
    if (std::abs(apart.genus - 1) < std::abs(reading.genus - 1)) reading = std::move(apart);
  }

  const BinaryVolume& volume = reading.volume;
  const Vec3 spacing = volume.spacing();
  ExtractedSurface result;
  ExtractionReport& report = result.report;
  report.genus = reading.genus;
  report.contact = reading.contact;
  report.components = reading.cleaning.components;
  report.voxels = reading.cleaning.kept_voxels + reading.cleaning.filled_voxels;
  report.lost_voxels = reading.cleaning.lost_voxels;
  report.filled_voxels = reading.cleaning.filled_voxels;
  report.cut_at = reading.cleaning.cut_at;
  report.voxel_volume = static_cast<double>(report.voxels) * spacing.prod();

  TriangleSoup& surface = result.surface;
  surface = std::move(reading.surface);
  for (Vec3& p : surface.points) p = p.cwiseProduct(spacing);
  extract::SmoothedSurface smoothed = extract::smooth_surface(surface, spacing, report.voxel_volume, options);
  surface.points = std::move(smoothed.points);
  report.restrained = smoothed.restrained;
  report.volume = signed_volume(build_mesh(surface));
  const TriangleSoup boundary = voxel_boundary(volume);
  report.deviation_mm = deviation(surface, boundary, Vec3::Ones(), spacing);
  report.deviation = deviation(surface, boundary, spacing.cwiseInverse(), Vec3::Ones());

  for (Vec3& p : surface.points) p = volume.origin + volume.axes * p.cwiseQuotient(spacing);
  if (volume.axes.determinant() < 0)
    for (auto& t : surface.triangles) std::swap(t[1], t[2]);
  return result;
}

}  // namespace foramen
