#include "foramen/topology/linking.hpp"

#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <optional>
#include <sstream>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"

namespace foramen {
namespace {

// A sum of solid angles further than this from an integer means that the polygons touch.
constexpr double integer_tolerance = 1e-3;
// Two segments whose Gauss integral is this close to its supremum, one half, touch: on which side they pass
// is lost to rounding.
constexpr double touching_tolerance = 1e-10;
// How far a loop is pushed off the surface, in lengths of the edge it crosses. Far enough above rounding
// (1e-16 of the coordinates), near enough not to reach another part of the surface. Two in a row must agree.
constexpr std::array pushes{1e-3, 1e-4, 1e-5, 1e-6};

// Gauss integral of two segments, in units of 2 pi: half the signed solid angle of the parallelogram of
// directions from one segment to the other, that is, of two spherical triangles [vanoosterom1983], whose half
// angles are added as arguments of complex numbers. The sum lies between -pi and pi and stays accurate when
// the segments nearly touch.
double half_solid_angle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const double la = a.norm(), lb = b.norm(), lc = c.norm(), ld = d.norm();
  const double triple = a.dot(b.cross(c));
  const double abc = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
  const double acd = la * lc * ld + a.dot(c) * ld + c.dot(d) * la + d.dot(a) * lc;
  return std::atan2(triple * (abc + acd), abc * acd - triple * triple);
}

// NaN where two segments touch.
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

// The edges crossed by the loop when it is moved a little to its left, into the faces beside it. Each
// halfedge leaves a vertex of the loop, and is crossed from its own face to its twin's. Unlike the loop, this
// walk meets no vertex, and shares no edge with any loop.
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

// The walk through the faces left of the loop, lifted outward at the midpoint of each edge it crosses, by
// `push` lengths of that edge. The mean of the two normals there leans outward from both faces, so every
// segment of the polygon lies strictly above the one face it passes: this needs no direction at vertices,
// where a fold can leave none that is outward from all faces.
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

std::string shown(const Eigen::Matrix2i& m) {
  std::ostringstream text;
  text << "[[" << m(0, 0) << ", " << m(0, 1) << "], [" << m(1, 0) << ", " << m(1, 1) << "]]";
  return text.str();
}

}  // namespace

int linking_number(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  const double sum = gauss_integral(a, b);
  const auto number = nearest_integer(sum);
  if (!number)
    throw ConvergenceError("the linking number of two polygons comes out as " + std::to_string(sum) +
                           ", which is no integer: they touch, so they have none; move them apart");
  return *number;
}

int intersection_number(const Mesh& mesh, const EdgeLoop& first, const EdgeLoop& second) {
  HalfedgeMap<int> walked(mesh.halfedge_count(), 0);
  for (HalfedgeId h : first) {
    ++walked[h];
    --walked[mesh.twin(h)];
  }
  int sum = 0;
  for (HalfedgeId h : crossings_left_of(mesh, second)) sum -= walked[h];  // from the left of h to its right
  return sum;
}

Eigen::Matrix2i seifert_matrix(const Mesh& mesh, const EdgeLoop& first, const EdgeLoop& second) {
  if (!mesh.is_closed())
    throw TopologyError("a Seifert matrix needs a closed surface, found one with boundary");
  const int crossing = intersection_number(mesh, first, second);
  if (std::abs(crossing) != 1)
    throw TopologyError("two loops that intersect " + std::to_string(crossing) +
                        " times (algebraically) are no basis: needs 1 or -1");
  // Moving loop l from inside to outside passes it through loop k once for every intersection.
  const Eigen::Matrix2i antisymmetric{{0, -crossing}, {crossing, 0}};
  const std::array loops{positions_of(mesh, first), positions_of(mesh, second)};
  const std::array crossed{crossings_left_of(mesh, first), crossings_left_of(mesh, second)};

  std::optional<Eigen::Matrix2i> previous;
  std::string found;
  for (double push : pushes) {
    Eigen::Matrix2i s;
    bool integers = true;
    for (int l = 0; l < 2; ++l) {
      const auto lifted = pushed_outward(mesh, crossed[static_cast<std::size_t>(l)], push);
      for (int k = 0; k < 2; ++k) {
        const auto number = nearest_integer(gauss_integral(loops[static_cast<std::size_t>(k)], lifted));
        integers = integers && number.has_value();
        s(k, l) = number.value_or(0);
      }
    }
    if (!integers) {
      previous.reset();
      found += " no integers;";
      continue;
    }
    if (s - s.transpose() == antisymmetric) {
      if (previous == s) return s;
      previous = s;
    } else {
      previous.reset();
    }
    found.append(" ").append(shown(s)).append(";");
  }
  throw ConvergenceError("the linking numbers of the loops do not settle:" + found +
                         " the surface may intersect itself near a loop; repair it");
}

bool seifert_test(const Eigen::Matrix2i& a, const Eigen::Matrix2i& shape, const Eigen::Matrix2i& reference) {
  const int determinant = a(0, 0) * a(1, 1) - a(0, 1) * a(1, 0);
  const Eigen::Matrix2i carried = a.transpose() * shape * a;
  return determinant == 1 && carried == reference;
}

}  // namespace foramen
