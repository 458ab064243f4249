#pragma once
/// \file
/// On which side a point lies, decided exactly.

#include "foramen/core/mesh.hpp"

namespace foramen::detail {

/// The sign (-1, 0, 1) of \f$ \det(b-a,\, c-a,\, d-a) \f$: 1 where d lies on the side from which a, b, c run
/// counter-clockwise, 0 where the four points lie in one plane. In double precision where its error bound
/// decides, otherwise by exact sums of doubles \cite shewchuk1997.
/// \pre every coordinate is a multiple of 2^-340 and below 2^339 in absolute value: nothing computed here
/// leaves the range of a double
int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// The same in the plane, the sign of \f$ \det(b-a,\, c-a) \f$: 1 where a, b, c run counter-clockwise.
int orientation(const Vec2& a, const Vec2& b, const Vec2& c);

}  // namespace foramen::detail
