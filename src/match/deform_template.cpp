#include "match/deform_template.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <Eigen/Cholesky>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/spatial/surface_distance.hpp"
#include "match/oriented_points.hpp"
#include "spatial/point_index.hpp"

namespace foramen {
namespace {

constexpr std::uint64_t template_seed = 1, shape_seed = 2;

void check(const Mesh& surface, const Eigen::MatrixXd& functions, const DeformTemplateOptions& options,
           std::span<const Vec3> start) {
  const auto refuse = [](const std::string& what) { throw InvalidInput("deform_template: " + what); };
  if (functions.rows() != surface.vertex_count())
    refuse("found displacement functions at " + std::to_string(functions.rows()) + " points for " +
           std::to_string(surface.vertex_count()) + " vertices");
  if (!start.empty() && static_cast<int>(start.size()) != surface.vertex_count())
    refuse("start has " + std::to_string(start.size()) + " positions for " +
           std::to_string(surface.vertex_count()) + " vertices");
  if (options.noise_mm.empty()) refuse("noise must hold at least one level");
  check_options("deform_template", options);
}

/// Vertices of the template, stratified by area: the nearest corner of each sample of the surface.
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

/// All matches of one template vertex combined to \f$ (u - goal)^T W (u - goal) \f$; W and W goal are stored.
struct Pull {
  int vertex;
  Mat3 weight = Mat3::Zero();
  Vec3 weighted_goal = Vec3::Zero();
};

class Fit {
 public:
  Fit(const Mesh& surface, const Eigen::MatrixXd& functions, const Mesh& shape,
      const DeformTemplateOptions& options, const DisplacementPrior& prior)
      : surface_(surface),
        functions_(functions),
        options_(options),
        prior_(prior_form(prior, 3 * functions.cols())),
        shape_vertices_(oriented_vertices(shape), options.match.normal_weight),
        shape_samples_(oriented_samples(shape, options.match.samples, shape_seed)),
        vertices_(sampled_vertices(surface, options.match.samples)),
        area_per_sample_(total_area(shape) / options.match.samples),
        area_per_vertex_(total_area(surface) / options.match.samples) {}

  /// One iteration: computes matches and the displacement that fits them best.
  Mesh improved(const Mesh& bent, double noise) const {
    const IndexedPoints on_template(oriented_vertices(bent), options_.match.normal_weight);
    std::vector<VertexMatch> matches;
    matches.reserve(vertices_.size() + shape_samples_.size());
    for (const int v : vertices_) {
      const NearPoint near = shape_vertices_.nearest(on_template[v]);
      matches.push_back({v, shape_vertices_[near.index], near.distance(), area_per_vertex_});
    }
    for (const OrientedPoint& sample : shape_samples_) {
      const NearPoint near = on_template.nearest(sample);
      matches.push_back({near.index, sample, near.distance(), area_per_sample_});
    }
    return displaced(solved(pulls(matches, on_template, noise)));
  }

 private:
  std::vector<Pull> pulls(const std::vector<VertexMatch>& matches, const IndexedPoints& on_template,
                          double noise) const {
    const MatchScale scale{.noise_mm = noise, .cut_mm = match_cut(matches, options_.match)};
    std::vector<Pull> all;
    VertexMap<int> slot(surface_.vertex_count(), -1);
    for (const VertexMatch& m : matches) {
      if (m.distance >= scale.cut_mm) continue;
      const VertexId v(m.vertex);
      const Mat3 w = match_precision(m, on_template[m.vertex].normal, scale, options_.match);
      if (slot[v] < 0) {
        slot[v] = static_cast<int>(all.size());
        all.push_back({m.vertex});
      }
      Pull& pull = all[slot[v]];
      pull.weight += w;
      pull.weighted_goal += w * (m.partner.position - surface_.position(v));
    }
    return all;
  }

  // (P + sum phi^T W phi) a = q + sum phi^T W goal. Returns one column of coefficients per coordinate.
  Eigen::MatrixX3d solved(const std::vector<Pull>& pulls) const {
    const auto count = static_cast<Eigen::Index>(pulls.size()), rank = functions_.cols();
    Eigen::MatrixXd at_pulls(count, rank);
    for (Eigen::Index i = 0; i < count; ++i) at_pulls.row(i) = functions_.row(pulls[i].vertex);
    Eigen::MatrixXd hessian(3 * rank, 3 * rank), weighted(count, rank);
    Eigen::VectorXd right(3 * rank);
    for (Eigen::Index a = 0; a < 3; ++a) {
      Eigen::VectorXd goal(count);
      for (Eigen::Index i = 0; i < count; ++i) goal[i] = pulls[i].weighted_goal[a];
      right.segment(a * rank, rank).noalias() = at_pulls.transpose() * goal;
      for (Eigen::Index b = 0; b <= a; ++b) {
        for (Eigen::Index i = 0; i < count; ++i) weighted.row(i) = pulls[i].weight(a, b) * at_pulls.row(i);
        hessian.block(a * rank, b * rank, rank, rank).noalias() = at_pulls.transpose() * weighted;
      }
    }
    hessian.triangularView<Eigen::Lower>() += prior_.precision;
    right += prior_.pull;
    const Eigen::VectorXd all = hessian.selfadjointView<Eigen::Lower>().llt().solve(right);
    return Eigen::Map<const Eigen::MatrixX3d>(all.data(), rank, 3);
  }

  Mesh displaced(const Eigen::MatrixX3d& coefficients) const {
    const Eigen::MatrixX3d displacements = functions_ * coefficients;
    std::vector<Vec3> positions;
    positions.reserve(surface_.vertex_count());
    for (VertexId v : surface_.vertices())
      positions.push_back(surface_.position(v) + displacements.row(v.index).transpose());
    return surface_.with_positions(std::move(positions));
  }

  const Mesh& surface_;
  const Eigen::MatrixXd& functions_;
  const DeformTemplateOptions& options_;
  PriorForm prior_;
  IndexedPoints shape_vertices_;
  std::vector<OrientedPoint> shape_samples_;
  std::vector<int> vertices_;  // of the template
  double area_per_sample_, area_per_vertex_;
};

}  // namespace

std::vector<Vec3> deform_template(const Mesh& surface, const Eigen::MatrixXd& functions, const Mesh& shape,
                                  const RunContext& ctx, const DeformTemplateOptions& options,
                                  std::span<const Vec3> start, const DisplacementPrior& prior) {
  check(surface, functions, options, start);
  const Fit fit(surface, functions, shape, options, prior);
  Mesh bent = start.empty() ? surface : surface.with_positions({start.begin(), start.end()});
  for (const double noise : options.noise_mm)
    for (int k = 0; k < options.iterations; ++k) {
      ctx.check();
      bent = fit.improved(bent, noise);
    }
  return {bent.positions().begin(), bent.positions().end()};
}

}  // namespace foramen
