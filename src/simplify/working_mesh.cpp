#include "simplify/working_mesh.hpp"

#include <algorithm>
#include <numbers>
#include <optional>
#include <queue>
#include <string>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "simplify/collapsible_mesh.hpp"
#include "simplify/quadric.hpp"

namespace foramen {
namespace {

/// Weight of squared distances between points relative to squared distances to planes. It keeps the vertices
/// evenly distributed on flat parts.
constexpr double spread_weight = 0.03;
/// Weight of the shape term: 1/shape - 1 of the worst new triangle times the error is added to the cost.
constexpr double shape_weight = 1.0;
/// Smallest shape of a new triangle, unless the removed vertex already has a triangle of worse shape.
constexpr double smallest_shape = 0.4;
/// Cosine of the angle (60 degrees) by which a triangle may turn in one collapse.
constexpr double smallest_cosine = 0.5;
constexpr int largest_valence = 9, smallest_valence = 4;
constexpr std::size_t collapses_between_checks = 1024;

/// Size, direction and shape of a triangle. Shape = 4 sqrt(3) area / (sum of squared sides): 1 for an
/// equilateral triangle, 0 for a needle or a cap.
struct Form {
  Vec3 normal = Vec3::Zero();  ///< of length twice_area
  double twice_area = 0;
  double shape = 0;
};

Form form_of(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a;
  const Vec3 normal = ab.cross(ac);
  const double twice_area = normal.norm();
  const double squares = ab.squaredNorm() + ac.squaredNorm() + (c - b).squaredNorm();
  return {normal, twice_area, squares > 0 ? 2 * std::numbers::sqrt3 * twice_area / squares : 0};
}

struct Candidate {
  double error =
      0;  ///< error of the kept vertex for the part of the surface that the removed vertex represented
  double cost = 0;  ///< growth of the error by the collapse
  HalfedgeId halfedge;
};

struct QueueEntry {
  double cost;
  VertexId vertex;
  int version;
  // std::priority_queue returns the largest element first, so the order is reversed: the smallest cost is the
  // largest element, and of equal costs the smallest index.
  friend bool operator<(const QueueEntry& a, const QueueEntry& b) {
    return a.cost != b.cost ? a.cost > b.cost : a.vertex > b.vertex;
  }
};

/// Greedy simplification. A queue holds the best collapse of every vertex, cheapest first.
class Simplifier {
 public:
  explicit Simplifier(const Mesh& mesh);
  std::vector<Collapse> run(int target_vertices, const RunContext& ctx);
  const CollapsibleMesh& mesh() const { return mesh_; }

 private:
  const Vec3& point(VertexId v) const { return points_[v.index]; }
  Form form(FaceId f) const;
  void enqueue(VertexId v);
  std::optional<Candidate> best_candidate(VertexId v);
  void list_candidates(VertexId v);
  double worst_shape_before() const;
  std::optional<double> worst_shape_after(HalfedgeId h, double worst_before) const;
  bool keeps_valences(HalfedgeId h) const;
  void update_after(const Collapse& done);

  CollapsibleMesh mesh_;
  std::vector<Vec3> points_;
  VertexMap<Quadric> quadrics_;
  FaceMap<Form> forms_;
  VertexMap<int> versions_;  // queue entries of an older version are invalid
  VertexMap<HalfedgeId> favourite_;
  std::priority_queue<QueueEntry> queue_;
  // Scratch memory for the faces around one vertex and for its neighbours.
  std::vector<HalfedgeId> fan_, ring_;
  std::vector<Candidate> candidates_;  // scratch
};

Simplifier::Simplifier(const Mesh& mesh)
    : mesh_(mesh),
      points_(mesh.positions().begin(), mesh.positions().end()),
      quadrics_(mesh.vertex_count()),
      forms_(mesh.face_count()),
      versions_(mesh.vertex_count(), 0),
      favourite_(mesh.vertex_count()) {
  // Quadrics lose digits far from the origin.
  const BoundingBox box = bounding_box(points_);
  const Vec3 centre = 0.5 * (box.low + box.high);
  for (Vec3& p : points_) p -= centre;

  for (FaceId f : mesh.faces()) {
    forms_[f] = form(f);
    const double third = forms_[f].twice_area / 6;
    if (!(third > 0)) continue;
    const Vec3 normal = forms_[f].normal / forms_[f].twice_area;
    for (VertexId v : mesh.corners(f)) {
      quadrics_[v].add_plane(third, normal, point(v));
      quadrics_[v].add_point(spread_weight * third, point(v));
    }
  }
  for (VertexId v : mesh.vertices()) enqueue(v);
}

Form Simplifier::form(FaceId f) const {
  const auto& t = mesh_.corners(f);
  return form_of(point(VertexId(t[0])), point(VertexId(t[1])), point(VertexId(t[2])));
}

bool Simplifier::keeps_valences(HalfedgeId h) const {
  return mesh_.valence(mesh_.from(h)) + mesh_.valence(mesh_.to(h)) - 4 <= largest_valence &&
         mesh_.valence(mesh_.apex(h)) > smallest_valence &&
         mesh_.valence(mesh_.apex(mesh_.twin(h))) > smallest_valence;
}

double Simplifier::worst_shape_before() const {
  double worst = 1;
  for (HalfedgeId k : fan_) worst = std::min(worst, forms_[Mesh::face(k)].shape);
  return worst;
}

// The shape of the worst new triangle; nullopt if a triangle would turn too far or become too bad.
std::optional<double> Simplifier::worst_shape_after(HalfedgeId h, double worst_before) const {
  const Vec3& target = point(mesh_.to(h));
  const FaceId left = Mesh::face(h), right = Mesh::face(mesh_.twin(h));
  const double needed = std::min(smallest_shape, worst_before);
  double worst = 1;
  for (HalfedgeId k : fan_) {
    const FaceId f = Mesh::face(k);
    if (f == left || f == right) continue;
    const Form after = form_of(target, point(mesh_.to(k)), point(mesh_.apex(k)));
    const Form& before = forms_[f];
    if (!(after.shape > 0) || after.shape < needed) return std::nullopt;
    if (after.normal.dot(before.normal) < smallest_cosine * after.twice_area * before.twice_area)
      return std::nullopt;
    worst = std::min(worst, after.shape);
  }
  return worst;
}

void Simplifier::list_candidates(VertexId v) {
  mesh_.fan(mesh_.outgoing(v), fan_);
  candidates_.clear();
  const double error_now = quadrics_[v](point(v));
  for (HalfedgeId h : fan_) {
    const double error = quadrics_[v](point(mesh_.to(h)));
    candidates_.push_back({error, error - error_now, h});
  }
  std::sort(candidates_.begin(), candidates_.end(), [&](const Candidate& a, const Candidate& b) {
    return a.cost != b.cost ? a.cost < b.cost : mesh_.to(a.halfedge) < mesh_.to(b.halfedge);
  });
}

std::optional<Candidate> Simplifier::best_candidate(VertexId v) {
  list_candidates(v);
  const double worst_before = worst_shape_before();
  std::optional<Candidate> best;
  for (Candidate c : candidates_) {
    // The shape term can only raise the cost, so later candidates are not cheaper.
    if (best && best->cost <= c.cost) break;
    if (!keeps_valences(c.halfedge)) continue;
    const std::optional<double> shape = worst_shape_after(c.halfedge, worst_before);
    if (!shape) continue;
    c.cost += shape_weight * std::max(0.0, 1 / *shape - 1) * c.error;
    if ((!best || c.cost < best->cost) && mesh_.link_condition(c.halfedge)) best = c;
  }
  return best;
}

void Simplifier::enqueue(VertexId v) {
  ++versions_[v];
  const std::optional<Candidate> best = best_candidate(v);
  if (!best) return;
  favourite_[v] = best->halfedge;
  queue_.push({best->cost, v, versions_[v]});
}

void Simplifier::update_after(const Collapse& done) {
  quadrics_[done.kept] += quadrics_[done.removed];
  for (FaceId f : done.moved_faces) forms_[f] = form(f);
  mesh_.fan(mesh_.outgoing(done.kept), ring_);
  enqueue(done.kept);
  for (HalfedgeId h : ring_) enqueue(mesh_.to(h));
}

std::vector<Collapse> Simplifier::run(int target_vertices, const RunContext& ctx) {
  std::vector<Collapse> collapses;
  collapses.reserve(mesh_.vertex_count() - target_vertices);
  while (mesh_.vertex_count() > target_vertices && !queue_.empty()) {
    const QueueEntry top = queue_.top();
    queue_.pop();
    if (!mesh_.alive(top.vertex) || top.version != versions_[top.vertex]) continue;
    const HalfedgeId h = favourite_[top.vertex];
    // The version counts changes of the faces around the vertex only. Valences of neighbours and their
    // connections may have changed without it.
    if (!keeps_valences(h) || !mesh_.link_condition(h)) {
      enqueue(top.vertex);
      continue;
    }
    collapses.push_back(mesh_.collapse(h));
    update_after(collapses.back());
    if (collapses.size() % collapses_between_checks == 0) ctx.check();
  }
  return collapses;
}

WorkingMesh assembled(const Mesh& input, const CollapsibleMesh& shrunk, std::vector<Collapse> collapses) {
  WorkingMesh out;
  VertexMap<int> number(input.vertex_count(), -1);
  TriangleSoup soup;
  for (VertexId v : input.vertices()) {
    if (!shrunk.alive(v)) continue;
    number[v] = static_cast<int>(soup.points.size());
    soup.points.push_back(input.position(v));
    out.vertex_origin.values().push_back(v);
  }
  for (FaceId f : input.faces()) {
    if (!shrunk.alive(f)) continue;
    const auto& t = shrunk.corners(f);
    soup.triangles.push_back({number[VertexId(t[0])], number[VertexId(t[1])], number[VertexId(t[2])]});
    out.face_origin.values().push_back(f);
  }
  out.mesh = build_mesh(std::move(soup));
  out.collapses = std::move(collapses);
  return out;
}

template <class IdType>
IdMap<IdType, IdType> identity(int count) {
  IdMap<IdType, IdType> map(count);
  for (IdType id : map.ids()) map[id] = id;
  return map;
}

}  // namespace

WorkingMesh simplify(const Mesh& mesh, const RunContext& ctx, const SimplifyOptions& options) {
  if (options.target_vertices < 4)
    throw InvalidInput("simplify: target_vertices is " + std::to_string(options.target_vertices) +
                       ", but no closed mesh has fewer than 4 vertices");
  if (!mesh.is_closed()) throw TopologyError("simplify: needs a closed mesh; close its holes first");
  if (mesh.vertex_count() <= options.target_vertices)
    return {mesh, identity<VertexId>(mesh.vertex_count()), identity<FaceId>(mesh.face_count()), {}};
  Simplifier simplifier(mesh);
  std::vector<Collapse> collapses = simplifier.run(options.target_vertices, ctx);
  return assembled(mesh, simplifier.mesh(), std::move(collapses));
}

}  // namespace foramen
