#include "topology/lifted_loop.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"

namespace foramen::topology_detail {
namespace {

// If a Gauss integral differs from an integer by more than this, the polygons touch.
constexpr double integer_tolerance = 1e-3;
// Two segments touch if their Gauss integral is this close to its supremum of one half. On which side one
// passes the other is lost in rounding then.
constexpr double touching_tolerance = 1e-10;
// The Gauss integral of two segments in units of 2 pi: half the signed solid angle of the spherical
// quadrilateral of directions from one segment to the other. It is the sum over two spherical triangles
// [vanoosterom1983], whose half angles are added as arguments of complex numbers. The sum lies between -pi
// and pi and stays accurate for segments that nearly touch.
double half_solid_angle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const double la = a.norm(), lb = b.norm(), lc = c.norm(), ld = d.norm();
  const double triple = a.dot(b.cross(c));
  const double abc = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
  const double acd = la * lc * ld + a.dot(c) * ld + c.dot(d) * la + d.dot(a) * lc;
  return std::atan2(triple * (abc + acd), abc * acd - triple * triple);
}

}  // namespace

double gauss_integral(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vec3 &p = a[i], &q = a[(i + 1) % a.size()];
    for (std::size_t j = 0; j < b.size(); ++j) {
      const Vec3 &r = b[j], &s = b[(j + 1) % b.size()];
      const double turns = half_solid_angle(r - p, r - q, s - q, s - p) / (2 * std::numbers::pi);
      if (!(std::abs(turns) < 0.5 - touching_tolerance)) return std::numeric_limits<double>::quiet_NaN();
      sum += turns;
    }
  }
  return sum;
}

std::optional<int> nearest_integer(double x) {
  const double rounded = std::round(x);
  if (!(std::abs(x - rounded) <= integer_tolerance)) return std::nullopt;
  return static_cast<int>(rounded);
}

std::vector<HalfedgeId> crossings_left_of(const Mesh& mesh, const EdgeLoop& loop) {
  std::vector<HalfedgeId> crossed;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const HalfedgeId following = loop[(i + 1) % loop.size()];
    if (mesh.to(loop[i]) != mesh.from(following))
      throw InvalidInput("edge " + std::to_string(i) + " of a loop does not end where the next one begins");
    for (HalfedgeId h = Mesh::next(loop[i]); h != following; h = Mesh::next(mesh.twin(h)))
      crossed.push_back(h);
  }
  return crossed;
}

std::vector<Vec3> positions_of(const Mesh& mesh, const EdgeLoop& loop) {
  std::vector<Vec3> polygon;
  for (HalfedgeId h : loop) polygon.push_back(mesh.position(mesh.from(h)));
  return polygon;
}

// The mean of the two normals at an edge points outward from both faces. Each segment of the polygon passes
// over one face, so it lies strictly above that face. Vertices are avoided, because at a fold there may be no
// direction that points outward from all faces of a vertex.
std::vector<Vec3> pushed_outward(const Mesh& mesh, const std::vector<HalfedgeId>& crossed, double push) {
  std::vector<Vec3> polygon;
  for (HalfedgeId h : crossed) {
    const Vec3 &a = mesh.position(mesh.from(h)), &b = mesh.position(mesh.to(h));
    const Vec3 normals =
        unit_normal(mesh.triangle(Mesh::face(h))) + unit_normal(mesh.triangle(Mesh::face(mesh.twin(h))));
    polygon.push_back((a + b) / 2 + push * (b - a).norm() * normals.normalized());
  }
  return polygon;
}

}  // namespace foramen::topology_detail
