#include "match/two_way_matches.hpp"

#include "foramen/spatial/surface_distance.hpp"
#include "match/principal_curvatures.hpp"

namespace foramen {
namespace {

constexpr std::uint64_t template_seed = 1, shape_seed = 2;
constexpr double curvature_radius_mm = 2.5;

// The nearest corner of each sample of the surface.
std::vector<int> sampled_vertices(const Mesh& surface, int count) {
  std::vector<int> vertices;
  vertices.reserve(count);
  for (const SurfacePoint& p : sample_surface(surface, count, Rng(template_seed))) {
    Eigen::Index corner = 0;
    p.barycentric.maxCoeff(&corner);
    vertices.push_back(surface.corners(p.face)[corner].index);
  }
  return vertices;
}

std::vector<double> curvedness_at_vertices(const Mesh& mesh) {
  std::vector<double> values;
  values.reserve(mesh.vertex_count());
  const auto curvatures = principal_curvatures(mesh, vertex_normals(mesh), curvature_radius_mm);
  for (VertexId v : mesh.vertices()) values.push_back(curvedness(curvatures[v]));
  return values;
}

}  // namespace

TwoWayMatches::TwoWayMatches(const Mesh& surface, const Mesh& shape, const MatchOptions& options)
    : surface_(surface),
      options_(options),
      vertices_(sampled_vertices(surface, options.samples)),
      area_per_sample_(total_area(shape) / options.samples),
      area_per_vertex_(total_area(surface) / options.samples) {
  std::vector<OrientedPoint> points = oriented_vertices(shape);
  if (options.curved_share > 0) {
    template_curvedness_ = curvedness_at_vertices(surface);
    const std::vector<double> of_shape = curvedness_at_vertices(shape);
    for (std::size_t i = 0; i < points.size(); ++i) points[i].curvedness = of_shape[i];
  }
  shape_samples_ = oriented_samples(shape, points, options.samples, shape_seed);
  shape_vertices_.emplace(std::move(points), options.normal_weight);
}

std::vector<VertexPull> TwoWayMatches::pulls(const Mesh& bent, double noise_mm) const {
  std::vector<OrientedPoint> points = oriented_vertices(bent);
  for (std::size_t i = 0; i < template_curvedness_.size(); ++i)
    points[i].curvedness = template_curvedness_[i];
  const IndexedPoints on_template(std::move(points), options_.normal_weight);
  std::vector<VertexMatch> matches;
  matches.reserve(vertices_.size() + shape_samples_.size());
  for (const int v : vertices_) {
    const NearPoint near = shape_vertices_->nearest(on_template[v]);
    matches.push_back({v, (*shape_vertices_)[near.index], near.distance(), area_per_vertex_});
  }
  for (const OrientedPoint& sample : shape_samples_) {
    const NearPoint near = on_template.nearest(sample);
    matches.push_back({near.index, sample, near.distance(), area_per_sample_});
  }

  const MatchScale scale{.noise_mm = noise_mm, .cut_mm = match_cut(matches, options_)};
  std::vector<VertexPull> all;
  VertexMap<int> slot(bent.vertex_count(), -1);
  for (const VertexMatch& m : matches) {
    if (m.distance >= scale.cut_mm) continue;
    const VertexId v(m.vertex);
    const Mat3 w = match_precision(m, on_template[m.vertex], scale, options_);
    if (slot[v] < 0) {
      slot[v] = static_cast<int>(all.size());
      all.push_back({m.vertex});
    }
    VertexPull& pull = all[slot[v]];
    pull.weight += w;
    pull.weighted_shift += w * (m.partner.position - surface_.position(v));
  }
  return all;
}

}  // namespace foramen
