#include "parameterize/map_energy.hpp"

#include <cmath>
#include <limits>
#include <string>

#include <Eigen/LU>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/parameterize/torus_map.hpp"

namespace foramen {
namespace {

void check_options(const OptimiseMapOptions& options, bool has_objective) {
  if (has_objective && !(options.lambda > 0))
    throw InvalidInput("lambda must be > 0, found " + std::to_string(options.lambda) +
                       ": without the distortion term nothing keeps triangles from collapsing");
  if (options.free_lattice && has_objective)
    throw InvalidInput(
        "the lattice can only be free without a correspondence objective, whose targets lie on a given "
        "lattice");
  if (options.free_lattice && options.optimiser != Optimiser::newton)
    throw InvalidInput("the lattice can only be free with the Newton optimiser");
}

void check_metric(const Mesh& mesh, const TargetMetric& metric, const OptimiseMapOptions& options) {
  if (options.free_lattice) throw InvalidInput("the lattice can only be free without a target's metric");
  if (metric.to_target.size() != mesh.face_count() || !(metric.area > 0))
    throw InvalidInput("the target's metric has " + std::to_string(metric.to_target.size()) +
                       " matrices for " + std::to_string(mesh.face_count()) + " triangles, and area " +
                       std::to_string(metric.area));
  for (FaceId f : mesh.faces())
    if (!(metric.to_target[f].determinant() > 0))
      throw InvalidInput("the target's metric at triangle " + std::to_string(f.index) +
                         " turns the plane over or is not finite");
}

void check_map(const Mesh& mesh, const TorusMap& map) {
  if (map.turns.size() != mesh.vertex_count() || map.jumps.size() != mesh.halfedge_count())
    throw InvalidInput("the map has " + std::to_string(map.turns.size()) + " positions for " +
                       std::to_string(mesh.vertex_count()) + " vertices");
  if (map.lattice(1, 0) != 0 || !(map.lattice(0, 0) > 0) || !(map.lattice(1, 1) > 0))
    throw InvalidInput("the lattice of a torus map must be upper triangular with a positive diagonal");
}

}  // namespace

MapEnergy::MapEnergy(const Mesh& mesh, const TorusMap& start, const OptimiseMapOptions& options,
                     const CorrespondenceObjective* objective, const TargetMetric* metric)
    : mesh_(mesh), start_(start), objective_(objective) {
  check_options(options, objective != nullptr);
  check_map(mesh, start);
  if (metric) check_metric(mesh, *metric, options);
  const bool by_area = options.weighting == Weighting::area;
  const double surface = total_area(mesh), domain = metric ? metric->area : start.lattice.determinant();
  const double scale = std::sqrt(domain / surface), lambda = objective ? options.lambda : 1.0;
  const MapState first = state(start);
  triangles_.reserve(mesh.face_count());
  for (FaceId f : mesh.faces()) {
    Triangle t;
    const auto c = mesh.corners(f);
    t.corner = {c[0].index, c[1].index, c[2].index};
    t.jump = {start.jumps[Mesh::halfedge(f, 0)].cast<double>(),
              -start.jumps[Mesh::halfedge(f, 2)].cast<double>()};
    t.rest = rest_triangle(mesh.triangle(f), scale);
    if (metric) t.rest.to_target = metric->to_target[f];
    t.weight = lambda * (by_area ? t.rest.area / domain : 1.0);
    const std::string name = "triangle " + std::to_string(f.index);
    if (!t.rest.inverse.allFinite() || !(t.rest.area > 0))
      throw InvalidInput(name + " has no area on the surface; repair the mesh first");
    if (!(doubled_area(edges(t, first)) > 0))
      throw InvalidInput(name + " is flipped or has no area in the map to start from");
    triangles_.push_back(t);
  }
  if (!objective) return;
  vertex_weights_.assign(mesh.vertex_count(), 1.0);
  if (!by_area) return;
  const VertexMap<double> areas = vertex_areas(mesh);
  for (VertexId v : mesh.vertices()) vertex_weights_[v.index] = areas[v] / surface;
}

double MapEnergy::value(const MapState& state) const {
  double sum = 0;
  for (const Triangle& t : triangles_) {
    const double e = distortion(t.rest, edges(t, state));
    if (!std::isfinite(e)) return std::numeric_limits<double>::infinity();
    sum += t.weight * e;
  }
  if (objective_)
    for (int v = 0; v < static_cast<int>(state.x.cols()); ++v) sum += correspondence(v, state.x.col(v)).value;
  return sum;
}

CorrespondenceObjective::Term MapEnergy::correspondence(int vertex, const Vec2& plane_position) const {
  if (!objective_) return {};
  CorrespondenceObjective::Term term = objective_->term(VertexId(vertex), plane_position);
  const double weight = vertex_weights_[vertex];
  term.value *= weight;
  term.gradient *= weight;
  term.hessian *= weight;
  return term;
}

double MapEnergy::mean_distortion(const MapState& state) const {
  double sum = 0, area = 0;
  for (const Triangle& t : triangles_) {
    sum += t.rest.area * distortion(t.rest, edges(t, state));
    area += t.rest.area;
  }
  return sum / area;
}

MapState MapEnergy::state(const TorusMap& map) const {
  MapState s{Eigen::Matrix2Xd(2, mesh_.vertex_count()), map.lattice};
  for (VertexId v : mesh_.vertices()) s.x.col(v.index) = map.lattice * map.turns[v];
  return s;
}

TorusMap MapEnergy::map(const MapState& state) const {
  TorusMap out{state.lattice, VertexMap<Vec2>(mesh_.vertex_count(), Vec2::Zero()), start_.jumps};
  const Mat2 inverse = state.lattice.inverse();
  for (VertexId v : mesh_.vertices()) out.turns[v] = inverse * state.x.col(v.index);
  return out;
}

}  // namespace foramen
