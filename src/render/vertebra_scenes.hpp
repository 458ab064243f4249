#pragma once
/// \file
/// Cameras for a vertebra, and the surface with marked triangles.

#include <span>
#include <vector>

#include "render/render_scene.hpp"

namespace foramen {

/// A matrix whose columns are right, up and the line of sight. \pre direction and up are not parallel.
Mat3 picture_axes(const Vec3& direction, const Vec3& up);

/// The camera that sees all points in this direction, with a narrow margin.
Camera frame(std::span<const Vec3> points, const Vec3& direction, const Vec3& up);

/// The direction of view: along the shortest, middle or longest principal axis of the surface. The axis of
/// the canal is not known here. The longer of the other two axes is horizontal.
enum class View { along_shortest, along_middle, along_longest };

/// The camera that sees all points of `shown` in the direction of this view of `points`.
Camera view_of(std::span<const Vec3> points, View view, std::span<const Vec3> shown);

/// One scene per camera, all with the same contents and at the same scale. \pre at least one camera
std::vector<Scene> at_one_scale(const Scene& contents, const std::vector<Camera>& cameras);

/// The contents seen along the three principal axes of these points, at the same scale.
std::vector<Scene> three_views(std::span<const Vec3> points, const Scene& contents);

/// A surface with some triangles marked red.
SceneSurface marked_surface(const TriangleSoup& surface, const std::vector<int>& marked, SurfaceStyle style);

}  // namespace foramen
