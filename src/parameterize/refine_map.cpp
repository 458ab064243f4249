#include "parameterize/refine_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "parameterize/distortion.hpp"

namespace foramen {
namespace {

/// Least area of a new triangle, relative to its area with the vertex at the centre of the kernel.
constexpr double smallest_share_of_centre = 0.2;
/// Keeps the mean-value weights finite for sides shorter than this part of the longest one and for angles
/// this close to pi.
constexpr double mean_value_guard = 1e-6;
/// Number of Newton steps per vertex, and how often and by which factor a step is shortened until the
/// distortion decreases.
constexpr int relaxation_steps = 2, shortenings = 4;
constexpr double shortening = 0.4;

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }
Vec2 left_of(const Vec2& direction) { return Vec2(-direction.y(), direction.x()); }

/// The neighbours of a restored vertex, counter-clockwise; the first is the vertex into which it was
/// collapsed.
struct OneRing {
  std::vector<VertexId> vertices;
  std::vector<Vec2> plane;  ///< plane positions relative to the first, which is 0
  std::size_t size() const { return vertices.size(); }
  std::size_t after(std::size_t i) const { return i + 1 == size() ? 0 : i + 1; }
};

/// Twice the signed area of the triangle of side i of the ring and the point x: affine in x and positive
/// inside the kernel.
double twice_area(const OneRing& ring, std::size_t i, const Vec2& x) {
  const Vec2& a = ring.plane[i];
  return cross(ring.plane[ring.after(i)] - a, x - a);
}

bool strictly_inside(const OneRing& ring, const Vec2& x) {
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (!(twice_area(ring, i, x) > 0)) return false;
  return true;
}

/// The position that the mean-value weights of `centre` on the surface \cite floater2003 give in the plane.
/// It is exact if the surface is flat and the map affine.
Vec2 mean_value_position(const Mesh& surface, VertexId centre, const OneRing& ring) {
  const std::size_t n = ring.size();
  std::vector<Vec3> spokes(n);
  std::vector<double> lengths(n), half_tangents(n);
  double longest = 0;
  for (std::size_t i = 0; i < n; ++i) {
    spokes[i] = surface.position(ring.vertices[i]) - surface.position(centre);
    lengths[i] = spokes[i].norm();
    longest = std::max(longest, lengths[i]);
  }
  for (double& length : lengths) length = std::max(length, mean_value_guard * longest);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = ring.after(i);
    const double product = lengths[i] * lengths[j];
    const double one_plus_cosine = std::max(product + spokes[i].dot(spokes[j]), mean_value_guard * product);
    half_tangents[i] = spokes[i].cross(spokes[j]).norm() / one_plus_cosine;
  }
  Vec2 sum = Vec2::Zero();
  double total = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double weight = (half_tangents[i == 0 ? n - 1 : i - 1] + half_tangents[i]) / lengths[i];
    sum += weight * ring.plane[i];
    total += weight;
  }
  return total > 0 ? Vec2(sum / total) : Vec2(Vec2::Zero());
}

/// The part of a convex polygon where value(x), which is affine, is not negative.
template <class Affine>
void clip(std::vector<Vec2>& polygon, std::vector<Vec2>& scratch, const Affine& value) {
  scratch.clear();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &a = polygon[i], &b = polygon[i + 1 == polygon.size() ? 0 : i + 1];
    const double va = value(a), vb = value(b);
    if (va >= 0) scratch.push_back(a);
    if ((va < 0) != (vb < 0) && va != 0 && vb != 0) scratch.push_back(a + va / (va - vb) * (b - a));
  }
  polygon.swap(scratch);
}

std::optional<Vec2> centroid(const std::vector<Vec2>& polygon) {
  Vec2 sum = Vec2::Zero();
  double total = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i - 1] - polygon[0], b = polygon[i] - polygon[0];
    const double weight = cross(a, b);
    sum += weight * (a + b) / 3;
    total += weight;
  }
  if (!(total > 0)) return std::nullopt;
  return Vec2(polygon[0] + sum / total);
}

/// The centroid of the kernel, that is, of the set of points from which the whole ring is visible. Its
/// distance from each side is at least a third of the width of the kernel.
std::optional<Vec2> kernel_centre(const OneRing& ring) {
  Vec2 low = ring.plane[0], high = ring.plane[0];
  for (const Vec2& q : ring.plane) {
    low = low.cwiseMin(q);
    high = high.cwiseMax(q);
  }
  std::vector<Vec2> kernel = {low, {high.x(), low.y()}, high, {low.x(), high.y()}}, scratch;
  for (std::size_t i = 0; i < ring.size(); ++i)
    clip(kernel, scratch, [&](const Vec2& x) { return twice_area(ring, i, x); });
  return centroid(kernel);
}

/// A point of a kernel that is too small for clipping: on the bisector at the first vertex, halfway to the
/// border of the kernel.
Vec2 near_first_vertex(const OneRing& ring) {
  const Vec2 direction =
      left_of(ring.plane[1]).normalized() + left_of(-ring.plane[ring.size() - 1]).normalized();
  double reach = 1;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    const double here = twice_area(ring, i, Vec2::Zero()), there = twice_area(ring, i, direction);
    if (there < here) reach = std::min(reach, here / (here - there));
  }
  return 0.5 * reach * direction;
}

/// The point of the segment from `centre` to `wish` that is closest to `wish` among those at which no
/// triangle is too small (smallest_share_of_centre).
Vec2 well_inside(const OneRing& ring, const Vec2& centre, const Vec2& wish) {
  double step = 1;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const double at_centre = twice_area(ring, i, centre), at_wish = twice_area(ring, i, wish);
    if (at_wish < smallest_share_of_centre * at_centre)
      step = std::min(step, (1 - smallest_share_of_centre) * at_centre / (at_centre - at_wish));
  }
  return centre + step * (wish - centre);
}

/// The distortion of the triangles at a vertex as a function of its position x, in the frame of its ring.
class StarEnergy {
 public:
  /// \param scale  factor of lengths on the surface, as in rest_triangle()
  StarEnergy(const Mesh& surface, VertexId centre, const OneRing& ring, double scale) : ring_(ring) {
    rest_.reserve(ring.size());
    for (std::size_t i = 0; i < ring.size(); ++i)
      rest_.push_back(rest_triangle({surface.position(centre), surface.position(ring.vertices[i]),
                                     surface.position(ring.vertices[ring.after(i)])},
                                    scale));
  }

  double operator()(const Vec2& x) const {
    double sum = 0;
    for (std::size_t i = 0; i < ring_.size(); ++i)
      if (rest_[i].area > 0) sum += rest_[i].area * distortion(rest_[i], edges(i, x));
    return sum;
  }

  /// The Newton step, a direction of descent. It is not finite if no triangle has an area.
  Vec2 newton_step(const Vec2& x) const {
    Vec2 gradient = Vec2::Zero();
    Mat2 hessian = Mat2::Zero();
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      if (!(rest_[i].area > 0)) continue;
      const DistortionTerm term = distortion_term(rest_[i], edges(i, x));
      const Mat4& h = term.hessian;
      // x is the first corner of the triangle, so the derivative of both edges with respect to x is -1.
      gradient -= rest_[i].area * (term.gradient.head<2>() + term.gradient.tail<2>());
      hessian += rest_[i].area * (h.topLeftCorner<2, 2>() + h.topRightCorner<2, 2>() +
                                  h.bottomLeftCorner<2, 2>() + h.bottomRightCorner<2, 2>());
    }
    return -hessian.inverse() * gradient;
  }

 private:
  Vec4 edges(std::size_t i, const Vec2& x) const {
    Vec4 out;
    out << ring_.plane[i] - x, ring_.plane[ring_.after(i)] - x;
    return out;
  }

  const OneRing& ring_;
  std::vector<RestTriangle> rest_;
};

/// A position of smaller or equal distortion.
Vec2 relaxed(const StarEnergy& energy, Vec2 x) {
  double value = energy(x);
  for (int k = 0; k < relaxation_steps; ++k) {
    Vec2 step = energy.newton_step(x);
    if (!step.allFinite()) return x;
    double next = energy(x + step);
    for (int i = 0; i < shortenings && !(next < value); ++i) {
      step *= shortening;
      next = energy(x + step);
    }
    if (!(next < value)) return x;
    x += step;
    value = next;
  }
  return x;
}

class Refiner {
 public:
  Refiner(const Mesh& input, const WorkingMesh& working, const TorusMap& coarse);
  void undo(const Collapse& collapse);
  /// Moves a restored vertex to smaller distortion among its neighbours in the input mesh. \pre all collapses
  /// are undone
  void relax(VertexId v);
  TorusMap take() { return std::move(map_); }

 private:
  std::size_t corner_of(FaceId f, VertexId v) const;
  OneRing one_ring(const Collapse& collapse) const;
  Vec2 place(VertexId v, const OneRing& ring) const;
  void restore_faces(const Collapse& collapse);

  const Mesh& input_;
  std::vector<std::array<VertexId, 3>> corners_;  // corners of the faces that exist already
  TorusMap map_;
  Mat2 inverse_lattice_;
  double surface_scale_;  // factor of lengths that gives the surface the area of the domain
};

Refiner::Refiner(const Mesh& input, const WorkingMesh& working, const TorusMap& coarse)
    : input_(input),
      corners_(input.face_count()),
      map_{coarse.lattice, VertexMap<Vec2>(input.vertex_count(), Vec2::Zero()),
           HalfedgeMap<Vec2i>(input.halfedge_count(), Vec2i::Zero())},
      inverse_lattice_(coarse.lattice.inverse()),
      surface_scale_(std::sqrt(coarse.lattice.determinant() / total_area(input))) {
  for (VertexId v : working.mesh.vertices()) map_.turns[working.vertex_origin[v]] = coarse.turns[v];
  for (FaceId f : working.mesh.faces()) {
    const FaceId origin = working.face_origin[f];
    const auto corners = working.mesh.corners(f);
    for (std::size_t k = 0; k < 3; ++k) {
      const int corner = static_cast<int>(k);
      corners_[origin.index][k] = working.vertex_origin[corners[k]];
      map_.jumps[Mesh::halfedge(origin, corner)] = coarse.jumps[Mesh::halfedge(f, corner)];
    }
  }
}

std::size_t Refiner::corner_of(FaceId f, VertexId v) const {
  const auto& t = corners_[f.index];
  const auto it = std::find(t.begin(), t.end(), v);
  FORAMEN_ASSERT(it != t.end());
  return it - t.begin();
}

OneRing Refiner::one_ring(const Collapse& collapse) const {
  OneRing ring;
  ring.vertices.reserve(collapse.moved_faces.size() + 2);
  ring.plane.reserve(collapse.moved_faces.size() + 2);
  const Vec2& origin = map_.turns[collapse.kept];
  const auto add = [&](VertexId v, const Vec2i& jump) {
    ring.vertices.push_back(v);
    ring.plane.emplace_back(map_.lattice * (map_.turns[v] + jump.cast<double>() - origin));
  };
  add(collapse.kept, Vec2i::Zero());
  HalfedgeId last;
  for (FaceId f : collapse.moved_faces) {
    const HalfedgeId out = Mesh::halfedge(f, static_cast<int>(corner_of(f, collapse.kept)));
    add(corners_[f.index][Mesh::next(out).index % 3], map_.jumps[out]);
    last = Mesh::prev(out);
  }
  FORAMEN_ASSERT(last.valid());
  add(corners_[Mesh::face(last).index][last.index % 3], -map_.jumps[last]);
  return ring;
}

// The position of a restored vertex: the first of several candidates that is strictly inside the kernel after
// rounding to turns.
Vec2 Refiner::place(VertexId v, const OneRing& ring) const {
  const Vec2& origin = map_.turns[ring.vertices[0]];
  const auto rounded = [&](const Vec2& x) { return Vec2(origin + inverse_lattice_ * x); };
  const auto is_good = [&](const Vec2& turns) {
    return strictly_inside(ring, map_.lattice * (turns - origin));
  };
  if (const std::optional<Vec2> centre = kernel_centre(ring); centre && strictly_inside(ring, *centre)) {
    const Vec2 start = well_inside(ring, *centre, mean_value_position(input_, v, ring));
    Vec2 best = rounded(relaxed(StarEnergy(input_, v, ring, surface_scale_), start));
    if (is_good(best)) return best;
    if (is_good(rounded(start))) return rounded(start);
  }
  Vec2 turns = rounded(near_first_vertex(ring));
  if (!is_good(turns))
    throw ConvergenceError("refine_map: no room for vertex " + std::to_string(v.index) + " beside vertex " +
                           std::to_string(ring.vertices[0].index) +
                           ": the triangles there are too small in the plane for double precision");
  return turns;
}

// The restored vertex has no jump to `kept`, so halfedges to it have the same jumps as halfedges to `kept`.
// The jumps of the moved faces are therefore correct already.
void Refiner::restore_faces(const Collapse& collapse) {
  const auto jump_from_kept = [&](FaceId f, std::size_t corners_on) {
    const HalfedgeId out = Mesh::halfedge(f, static_cast<int>(corner_of(f, collapse.kept)));
    return corners_on == 1 ? map_.jumps[out] : Vec2i(-map_.jumps[Mesh::prev(out)]);
  };
  const std::array<Vec2i, 2> to_apex = {jump_from_kept(collapse.moved_faces.front(), 1),
                                        jump_from_kept(collapse.moved_faces.back(), 2)};
  for (std::size_t side = 0; side < 2; ++side) {
    const FaceId f = collapse.dropped_faces[side];
    const auto& corners = collapse.dropped_corners[side];
    corners_[f.index] = corners;
    const auto is_apex = [&](std::size_t k) {
      return corners[k] != collapse.removed && corners[k] != collapse.kept;
    };
    for (std::size_t k = 0; k < 3; ++k) {
      Vec2i& jump = map_.jumps[Mesh::halfedge(f, static_cast<int>(k))];
      jump = is_apex(k) ? Vec2i(-to_apex[side]) : is_apex((k + 1) % 3) ? to_apex[side] : Vec2i(Vec2i::Zero());
    }
  }
  for (FaceId f : collapse.moved_faces) corners_[f.index][corner_of(f, collapse.kept)] = collapse.removed;
}

void Refiner::undo(const Collapse& collapse) {
  map_.turns[collapse.removed] = place(collapse.removed, one_ring(collapse));
  restore_faces(collapse);
}

void Refiner::relax(VertexId v) {
  OneRing ring;
  for (HalfedgeId h : input_.fan(v)) {
    ring.vertices.push_back(input_.to(h));
    ring.plane.emplace_back(
        map_.lattice * (map_.turns[ring.vertices.back()] + map_.jumps[h].cast<double>() - map_.turns[v]));
  }
  const Vec2 before = map_.turns[v];
  const Vec2 step = relaxed(StarEnergy(input_, v, ring, surface_scale_), Vec2::Zero());
  const Vec2 after = before + inverse_lattice_ * step;
  if (strictly_inside(ring, map_.lattice * (after - before))) map_.turns[v] = after;
}

void check_fit(const Mesh& input, const WorkingMesh& working, const TorusMap& coarse) {
  const int removed = static_cast<int>(working.collapses.size());
  if (working.mesh.vertex_count() + removed != input.vertex_count() ||
      working.mesh.face_count() + 2 * removed != input.face_count())
    throw InvalidInput("refine_map: the working mesh and its " + std::to_string(removed) +
                       " collapses do not belong to this input mesh of " +
                       std::to_string(input.vertex_count()) + " vertices");
  if (coarse.turns.size() != working.mesh.vertex_count() ||
      coarse.jumps.size() != working.mesh.halfedge_count())
    throw InvalidInput("refine_map: the map has " + std::to_string(coarse.turns.size()) +
                       " vertices, the working mesh " + std::to_string(working.mesh.vertex_count()));
  for (FaceId f : working.mesh.faces())
    if (!(signed_area(working.mesh, coarse, f) > 0))
      throw InvalidInput("refine_map: triangle " + std::to_string(f.index) +
                         " of the working mesh is flipped or has no area in the map to be refined");
}

}  // namespace

TorusMap refine_map(const Mesh& input, const WorkingMesh& working, const TorusMap& coarse) {
  check_fit(input, working, coarse);
  Refiner refiner(input, working, coarse);
  for (auto it = working.collapses.rbegin(); it != working.collapses.rend(); ++it) refiner.undo(*it);
  for (const Collapse& collapse : working.collapses) refiner.relax(collapse.removed);
  TorusMap map = refiner.take();
  for (FaceId f : input.faces())
    if (!(signed_area(input, map, f) > 0))
      throw ConvergenceError("refine_map: triangle " + std::to_string(f.index) +
                             " has no area in the plane to double precision");
  return map;
}

}  // namespace foramen
