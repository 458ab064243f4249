#pragma once
/// \file
/// Quadrics: weighted sums of squared distances to planes and points \cite garland1997.

#include "foramen/core/mesh.hpp"

namespace foramen {

/// Q(x) = x^T A x - 2 b^T x + c.
struct Quadric {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;  // A
  double bx = 0, by = 0, bz = 0, c = 0;

  /// weight * (distance of x to the plane through p with unit normal n)^2
  void add_plane(double weight, const Vec3& n, const Vec3& p) {
    const double d = n.dot(p);
    xx += weight * n.x() * n.x(), xy += weight * n.x() * n.y(), xz += weight * n.x() * n.z();
    yy += weight * n.y() * n.y(), yz += weight * n.y() * n.z(), zz += weight * n.z() * n.z();
    bx += weight * d * n.x(), by += weight * d * n.y(), bz += weight * d * n.z();
    c += weight * d * d;
  }
  /// weight * |x - p|^2
  void add_point(double weight, const Vec3& p) {
    xx += weight, yy += weight, zz += weight;
    bx += weight * p.x(), by += weight * p.y(), bz += weight * p.z();
    c += weight * p.squaredNorm();
  }
  Quadric& operator+=(const Quadric& o) {
    xx += o.xx, xy += o.xy, xz += o.xz, yy += o.yy, yz += o.yz, zz += o.zz;
    bx += o.bx, by += o.by, bz += o.bz, c += o.c;
    return *this;
  }
  double operator()(const Vec3& p) const {
    const double x = p.x(), y = p.y(), z = p.z();
    return x * (xx * x + 2 * (xy * y + xz * z - bx)) + y * (yy * y + 2 * (yz * z - by)) +
           z * (zz * z - 2 * bz) + c;
  }
};

}  // namespace foramen
