#pragma once
/// \file
/// Exact orientation predicates in space and in the plane.

#include "foramen/core/mesh.hpp"

namespace foramen::detail {

/// The sign (-1, 0, 1) of \f$ \det(b-a,\, c-a,\, d-a) \f$: 1 where d lies on the side from which a, b, c run
/// counter-clockwise, 0 where the four points lie in one plane. The determinant is computed in double
/// precision and, if its error bound does not decide the sign, exactly as a sum of doubles \cite
/// shewchuk1997.
/// \pre every coordinate is a multiple of 2^-340 and below 2^339 in absolute value: with these bounds no
/// intermediate result overflows or underflows
int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// The same in the plane, the sign of \f$ \det(b-a,\, c-a) \f$: 1 where a, b, c run counter-clockwise.
int orientation(const Vec2& a, const Vec2& b, const Vec2& c);

}  // namespace foramen::detail
