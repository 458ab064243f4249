#pragma once
/// \file
/// Principal curvatures of a surface at its vertices.

#include "foramen/core/geometry.hpp"

namespace foramen {

/// In 1/mm, positive where the surface is convex.
struct PrincipalCurvatures {
  double largest = 0, smallest = 0;
};

/// The curvatures of the quadric z = a x^2 + b x y + c y^2 + d x + e y + f that fits the surface round each
/// vertex best, with z along the vertex's normal. Vertices within the radius that are connected to the vertex
/// inside the ball and do not face away from it take part, each with its area and with a Gaussian weight of
/// standard deviation radius / 2. Where fewer than six vertices take part, the curvatures are zero.
/// \param normals  unit normals of the vertices
VertexMap<PrincipalCurvatures> principal_curvatures(const Mesh& mesh, const VertexMap<Vec3>& normals,
                                                    double radius_mm);

/// (tanh(k1 / k0), tanh(k2 / k0)) with k0 = 0.3 / mm, so that the sharpest edge does not count for more
/// than a rim.
Vec2 squashed(const PrincipalCurvatures& k);

/// How much a place is curved, in [0, 1): the larger magnitude of the two squashed() curvatures.
double curvedness(const PrincipalCurvatures& k);

}  // namespace foramen
