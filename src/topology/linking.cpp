#include "topology/linking.hpp"

#include <array>
#include <cstdlib>
#include <optional>
#include <sstream>

#include "foramen/core/error.hpp"
#include "topology/lifted_loop.hpp"
#include "topology/periods.hpp"

namespace foramen {
namespace {

using topology_detail::crossings_left_of;
using topology_detail::gauss_integral;
using topology_detail::nearest_integer;
using topology_detail::positions_of;
using topology_detail::pushed_outward;
using topology_detail::pushes;

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
  // The walk crosses h from its left to its right.
  for (HalfedgeId h : crossings_left_of(mesh, second)) sum -= walked[h];
  return sum;
}

Eigen::Matrix2i seifert_matrix(const Mesh& mesh, const EdgeLoop& first, const EdgeLoop& second) {
  if (!mesh.is_closed())
    throw TopologyError("a Seifert matrix needs a closed surface, found one with boundary");
  const int crossing = intersection_number(mesh, first, second);
  if (std::abs(crossing) != 1)
    throw TopologyError("two loops that intersect " + std::to_string(crossing) +
                        " times (algebraically) are no basis: needs 1 or -1");
  // A loop l that moves from the inside to the outside of the surface passes through loop k once per
  // intersection.
  const Eigen::Matrix2i antisymmetric{{0, -crossing}, {crossing, 0}};
  const std::array loops{positions_of(mesh, first), positions_of(mesh, second)};
  const std::array crossed{crossings_left_of(mesh, first), crossings_left_of(mesh, second)};

  std::optional<Eigen::Matrix2i> previous;
  std::string found;
  for (double push : pushes) {
    Eigen::Matrix2i s;
    bool integers = true;
    for (int l = 0; l < 2; ++l) {
      const auto lifted = pushed_outward(mesh, crossed[l], push);
      for (int k = 0; k < 2; ++k) {
        const auto number = nearest_integer(gauss_integral(loops[k], lifted));
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
                         " the surface may intersect itself near a loop");
}

bool seifert_test(const Eigen::Matrix2i& a, const Eigen::Matrix2i& shape, const Eigen::Matrix2i& reference) {
  const int determinant = a(0, 0) * a(1, 1) - a(0, 1) * a(1, 0);
  const Eigen::Matrix2i carried = a.transpose() * shape * a;
  return determinant == 1 && carried == reference;
}

}  // namespace foramen
