#include "sampling/curvature_density.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"

namespace foramen {
namespace {

/// Weight of the mean of the neighbours in one round of smoothing.
constexpr double smoothing_share = 0.5;
/// Curvature is clamped at this quantile over the vertices, so that a single spike does not determine the
/// scale.
constexpr double clamp_quantile = 0.99;

/// Signed dihedral angle, positive where the surface is convex.
double dihedral_angle(const Vec3& left_normal, const Vec3& right_normal, const Vec3& edge_direction) {
  return std::atan2(right_normal.cross(left_normal).dot(edge_direction), left_normal.dot(right_normal));
}

/// The normal-cycle curvature tensor integrated over the region of a vertex, and the area of the region.
struct CurvatureMeasure {
  Mat3 tensor = Mat3::Zero();  // mm
  double area = 0;             // mm^2
};

VertexMap<CurvatureMeasure> curvature_measures(const Mesh& mesh) {
  VertexMap<CurvatureMeasure> out(mesh.vertex_count());
  const VertexMap<double> areas = vertex_areas(mesh);
  for (VertexId v : mesh.vertices()) out[v].area = areas[v];
  FaceMap<Vec3> normals(mesh.face_count(), Vec3::Zero());
  for (FaceId f : mesh.faces()) normals[f] = unit_normal(mesh.triangle(f));
  for (EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e);
    if (!mesh.twin(h).valid()) continue;
    const VertexId a = mesh.from(h), b = mesh.to(h);
    const Vec3 edge = mesh.position(b) - mesh.position(a);
    const double length = edge.norm();
    if (!(length > 0)) continue;
    const Vec3 direction = edge / length;
    const double angle = dihedral_angle(normals[Mesh::face(h)], normals[Mesh::face(mesh.twin(h))], direction);
    const Mat3 half = (0.5 * angle * length) * (direction * direction.transpose());
    out[a].tensor += half;
    out[b].tensor += half;
  }
  return out;
}

/// Blends each value with the mean of its neighbours, `rounds` times.
template <class Value, class Mean>
void smooth(const Mesh& mesh, VertexMap<Value>& values, int rounds, const Mean& blend) {
  std::vector<std::vector<int>> neighbours(mesh.vertex_count());
  for (HalfedgeId h : mesh.halfedges()) {
    neighbours[mesh.from(h).index].push_back(mesh.to(h).index);
    if (!mesh.twin(h).valid()) neighbours[mesh.to(h).index].push_back(mesh.from(h).index);
  }
  VertexMap<Value> old = values;
  for (int round = 0; round < rounds; ++round) {
    std::swap(old, values);
    for (VertexId v : mesh.vertices()) values[v] = blend(old, v, neighbours[v.index]);
  }
}

CurvatureMeasure blend_measure(const VertexMap<CurvatureMeasure>& old, VertexId v,
                               const std::vector<int>& around) {
  const double share = smoothing_share / static_cast<double>(around.size());
  CurvatureMeasure out{(1 - smoothing_share) * old[v].tensor, (1 - smoothing_share) * old[v].area};
  for (int w : around) {
    out.tensor += share * old[VertexId(w)].tensor;
    out.area += share * old[VertexId(w)].area;
  }
  return out;
}

double blend_density(const VertexMap<double>& old, VertexId v, const std::vector<int>& around) {
  const double share = smoothing_share / static_cast<double>(around.size());
  double out = (1 - smoothing_share) * old[v];
  for (int w : around) out += share * old[VertexId(w)];
  return out;
}

/// Number of rounds after which the smoothing kernel has the standard deviation `radius` in each direction.
/// One round adds smoothing_share times the squared edge length to the sum of the variances in both
/// directions.
int rounds_for_radius(double radius, double edge) {
  return static_cast<int>(std::lround(2 * radius * radius / (smoothing_share * edge * edge)));
}

/// (|K| + H^2) / 2 of a curvature tensor. The eigenvalue nearest to zero belongs to the normal; the others
/// are the principal curvatures.
double curvature(const CurvatureMeasure& measure) {
  if (!(measure.area > 0)) return 0;
  Eigen::SelfAdjointEigenSolver<Mat3> solver;
  solver.computeDirect(measure.tensor / measure.area, Eigen::EigenvaluesOnly);
  std::array<double, 3> k{solver.eigenvalues()[0], solver.eigenvalues()[1], solver.eigenvalues()[2]};
  std::sort(k.begin(), k.end(), [](double a, double b) { return std::abs(a) > std::abs(b); });
  const double mean = (k[0] + k[1]) / 2;
  return (std::abs(k[0] * k[1]) + mean * mean) / 2;
}

double quantile(std::vector<double> values, double share) {
  const auto k = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + k, values.end());
  return values[k];
}

}  // namespace

VertexMap<double> curvature_density(const Mesh& surface, const CurvatureDensityOptions& options) {
  check_options("curvature_density", options);
  const double radius = options.curvature_radius * std::sqrt(total_area(surface));
  if (!(radius > 0)) throw InvalidInput("curvature density: the surface has no area");

  VertexMap<CurvatureMeasure> measures = curvature_measures(surface);
  smooth(surface, measures, rounds_for_radius(radius, mean_edge_length(surface)), blend_measure);
  VertexMap<double> density(surface.vertex_count());
  for (VertexId v : surface.vertices()) density[v] = curvature(measures[v]);
  const double largest = quantile(density.values(), clamp_quantile);
  for (double& d : density)
    d = largest > 0 ? std::max(std::pow(std::min(d / largest, 1.0), options.contrast), options.floor) : 1.0;
  smooth(surface, density, options.smoothing_rounds, blend_density);
  return density;
}

}  // namespace foramen
