#pragma once
/// \file
/// Where to look at a vertebra from, and its marked triangles.

#include <span>
#include <vector>

#include "render/render_scene.hpp"

namespace foramen {

/// Columns: right, up and the line of sight. \pre the two are not parallel.
Mat3 picture_axes(const Vec3& direction, const Vec3& up);

/// The camera that sees all points in this direction, with a narrow margin.
Camera frame(std::span<const Vec3> points, const Vec3& direction, const Vec3& up);

/// From which side a surface is looked at, in its own principal frame (the canal's axis is not known to it):
/// along the shortest, middle or longest principal axis. The longer of the other two lies across.
enum class View { along_shortest, along_middle, along_longest };

/// `shown` (all points that are to be in the picture) from that side of `points`.
Camera view_of(std::span<const Vec3> points, View view, std::span<const Vec3> shown);

/// The contents seen by these cameras beside each other, at one scale. \pre at least one camera
std::vector<Scene> at_one_scale(const Scene& contents, const std::vector<Camera>& cameras);

/// The contents from the three sides of these points, at one scale.
std::vector<Scene> three_views(std::span<const Vec3> points, const Scene& contents);

/// A surface with some triangles marked red.
SceneSurface marked_surface(const TriangleSoup& surface, const std::vector<int>& marked, SurfaceStyle style);

}  // namespace foramen
