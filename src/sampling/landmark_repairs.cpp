#include "sampling/landmark_repairs.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace foramen::detail {
namespace {

// A repair may not lower the roundness (mean over shapes of the smallest angle, radians) of triangles, unless
// it stays above this.
constexpr double round_enough = 0.2;
// Positions tried for a corner: these fractions of the way to the mean of its neighbours, and this fraction
// of the way to each neighbour.
constexpr std::array centring_steps{1.0, 0.5};
constexpr double neighbour_step = 0.3;
// Index of the moved or new landmark in the triangles of a candidate.
constexpr int new_place = -1;

struct Candidate {
  Repair repair;
  std::vector<int> old_faces;
  std::vector<std::array<int, 3>> triangles;  // corners; new_place stands for the landmark at `place`
  Fixed2 place;
};

struct Value {
  Guilt guilt;
  double roundness = 0;
};

Fixed2 part(Fixed2 d, double share) {
  return {std::llround(share * static_cast<double>(d.x)), std::llround(share * static_cast<double>(d.y))};
}

class Search {
 public:
  Search(const TorusTriangulation& mesh, const LiftedLandmarks& lifted, const GuiltTable& guilt)
      : mesh_(mesh), lifted_(lifted), guilt_(guilt) {}

  Candidate flip(int h) const {
    const int t = mesh_.twin(h);
    const int a = mesh_.from(h), b = mesh_.to(h), c = mesh_.apex(h), d = mesh_.apex(t);
    return {{RepairKind::flip, h, {}, {a, b, c, d}, {}, 0}, {h / 3, t / 3}, {{d, b, c}, {d, c, a}}, {}};
  }

  Candidate split_edge(int h) const {
    const int t = mesh_.twin(h), m = new_place;
    const int a = mesh_.from(h), b = mesh_.to(h), c = mesh_.apex(h), d = mesh_.apex(t);
    return {{RepairKind::split_edge, h, {}, {a, b, c, d}, {}, 0},
            {h / 3, t / 3},
            {{a, m, c}, {m, b, c}, {m, a, d}, {b, m, d}},
            mesh_.place(a) + part(mesh_.along(h), 0.5)};
  }

  Candidate split_face(int f) const {
    const auto [a, b, c] = mesh_.corners(f);
    const int m = new_place;
    const Fixed2 centre = part(mesh_.along(3 * f) - mesh_.along(3 * f + 2), 1.0 / 3);
    return {{RepairKind::split_face, f, {}, {a, b, c}, {}, 0},
            {f},
            {{a, b, m}, {b, c, m}, {c, a, m}},
            mesh_.place(a) + centre};
  }

  /// A candidate that moves a landmark; it has no triangles if the move would flip a triangle of the torus.
  Candidate move(int v, Fixed2 by) const {
    const Fixed2 target = mesh_.place(v) + by;
    Candidate c{{RepairKind::move, v, target, {v}, {}, 0}, {}, {}, target};
    bool positive = true;
    mesh_.for_each_outgoing(v, [&](int h) {
      positive &= cross(mesh_.along(h) - by, mesh_.along(TorusTriangulation::next(h))) > 0;
      c.old_faces.push_back(h / 3);
      c.triangles.push_back({new_place, mesh_.to(h), mesh_.apex(h)});
      c.repair.support.push_back(mesh_.to(h));
    });
    if (!positive) c.triangles.clear();
    return c;
  }

  Guilt guilt_before(const Candidate& c) const {
    Guilt sum;
    for (const auto& of_shape : guilt_)
      for (int f : c.old_faces) sum = sum + of_shape[f];
    return sum;
  }

  double roundness_before(const Candidate& c) const {
    double worst = std::numeric_limits<double>::infinity();
    for (int f : c.old_faces) {
      double sum = 0;
      for (int s = 0; s < lifted_.shapes(); ++s)
        sum += smallest_angle(points(s, mesh_.corners(f), Vec3::Zero()));
      worst = std::min(worst, sum / lifted_.shapes());
    }
    return worst;
  }

  /// Sums the guilt of the new triangles over all shapes and stops when it reaches `limit`. Shapes with
  /// guilty triangles come first, so that a bad candidate is rejected early.
  Value evaluate(const Candidate& c, const Guilt& limit) const {
    Value value;
    std::vector<double> roundness(c.triangles.size(), 0.0);
    for (int s : shapes_by_guilt(c.old_faces)) {
      const Vec3 lifted = uses_new_place(c) ? lifted_.lift(s, c.place) : Vec3(Vec3::Zero());
      for (std::size_t k = 0; k < c.triangles.size(); ++k) {
        const auto triangle = points(s, c.triangles[k], lifted);
        roundness[k] += smallest_angle(triangle) / lifted_.shapes();
        value.guilt = value.guilt + Guilt{lifted_.guilty(s, triangle), meetings(s, c, k, lifted)};
        if (value.guilt >= limit) return value;
      }
    }
    value.roundness = *std::min_element(roundness.begin(), roundness.end());
    return value;
  }

 private:
  static bool uses_new_place(const Candidate& c) { return c.repair.kind != RepairKind::flip; }

  std::array<Vec3, 3> points(int shape, const std::array<int, 3>& corners, const Vec3& lifted) const {
    std::array<Vec3, 3> out;
    for (std::size_t k = 0; k < 3; ++k)
      out[k] = corners[k] == new_place ? lifted : lifted_.point(shape, corners[k]);
    return out;
  }

  NumberedTriangle numbered(int shape, const std::array<int, 3>& corners, const Vec3& lifted) const {
    return {{VertexId(corners[0]), VertexId(corners[1]), VertexId(corners[2])},
            points(shape, corners, lifted)};
  }

  /// Number of triangles that the k-th triangle of a candidate would intersect.
  int meetings(int shape, const Candidate& c, std::size_t k, const Vec3& lifted) const {
    if (!lifted_.surface(shape)) return 0;
    const NumberedTriangle triangle = numbered(shape, c.triangles[k], lifted);
    const auto stays = [&](FaceId f) {
      return std::find(c.old_faces.begin(), c.old_faces.end(), f.index) == c.old_faces.end();
    };
    const auto met = lifted_.faces_met(shape, triangle);
    auto count = std::count_if(met.begin(), met.end(), stays);
    for (std::size_t j = 0; j < c.triangles.size(); ++j)
      count += j != k && meet(triangle, numbered(shape, c.triangles[j], lifted));
    return static_cast<int>(count);
  }

  std::vector<int> shapes_by_guilt(const std::vector<int>& faces) const {
    std::vector<int> order(guilt_.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_partition(order.begin(), order.end(), [&](int s) {
      return std::any_of(faces.begin(), faces.end(), [&](int f) { return guilt_[s][f] != Guilt{}; });
    });
    return order;
  }

  const TorusTriangulation& mesh_;
  const LiftedLandmarks& lifted_;
  const GuiltTable& guilt_;
};

void take(Repair& best, const Candidate& c, const Value& value) {
  best = c.repair;
  best.guilt_after = value.guilt;
  best.roundness = value.roundness;
}

/// The best change without a new landmark. It must lower the guilt and must not create slivers.
Repair best_free_repair(const Search& search, const TorusTriangulation& mesh, int face) {
  Repair best;
  Guilt best_gain;
  const auto consider = [&](const Candidate& c) {
    if (c.triangles.empty()) return;
    const Guilt before = search.guilt_before(c);
    const Value after = search.evaluate(c, before);
    const Guilt gain = before - after.guilt;
    if (gain <= Guilt{} || gain < best_gain) return;
    if (after.roundness < round_enough && after.roundness < search.roundness_before(c)) return;
    if (gain == best_gain && after.roundness <= best.roundness) return;
    take(best, c, after);
    best_gain = gain;
  };
  for (int k = 0; k < 3; ++k)
    if (mesh.can_flip(3 * face + k)) consider(search.flip(3 * face + k));
  if (best.kind != RepairKind::none && best.guilt_after == Guilt{}) return best;
  for (int v : mesh.corners(face)) {
    Fixed2 sum;
    int count = 0;
    mesh.for_each_outgoing(v, [&](int h) {
      sum = sum + mesh.along(h);
      ++count;
    });
    for (double step : centring_steps) consider(search.move(v, part(sum, step / count)));
    mesh.for_each_outgoing(v, [&](int h) { consider(search.move(v, part(mesh.along(h), neighbour_step))); });
  }
  return best;
}

/// The best change by a new landmark. It may leave the guilt as it was, since smaller triangles give the next
/// round more freedom.
Repair best_insertion(const Search& search, int face, bool must_help) {
  constexpr Guilt no_limit{std::numeric_limits<int>::max(), 0};
  Repair best;
  Guilt best_gain = must_help ? Guilt{} : Guilt{} - no_limit;
  const auto consider = [&](const Candidate& c) {
    const Guilt before = search.guilt_before(c);
    const Value after = search.evaluate(c, must_help ? before + Guilt{0, 1} : no_limit);
    const Guilt gain = before - after.guilt;
    if (gain < best_gain || (gain == best_gain && after.roundness <= best.roundness)) return;
    take(best, c, after);
    best_gain = gain;
  };
  for (int k = 0; k < 3; ++k) consider(search.split_edge(3 * face + k));
  consider(search.split_face(face));
  return best;
}

}  // namespace

Repair best_repair(const TorusTriangulation& mesh, const LiftedLandmarks& lifted, const GuiltTable& guilt,
                   int face, Insertion insertion) {
  const Search search(mesh, lifted, guilt);
  Repair free = best_free_repair(search, mesh, face);
  if (free.kind != RepairKind::none || insertion == Insertion::none) return free;
  return best_insertion(search, face, insertion == Insertion::helpful);
}

}  // namespace foramen::detail
