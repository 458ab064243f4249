#include "match/deform_template.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <Eigen/Cholesky>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "match/two_way_matches.hpp"

namespace foramen {
namespace {

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

class Fit {
 public:
  Fit(const Mesh& surface, const Eigen::MatrixXd& functions, const DisplacementPrior& prior)
      : surface_(surface), functions_(functions), prior_(prior_form(prior, 3 * functions.cols())) {}

  /// The displacement that fits the pulls best.
  Mesh fitted(const std::vector<VertexPull>& pulls) const { return displaced(solved(pulls)); }

 private:
  // (P + sum phi^T W phi) a = q + sum phi^T W goal. Returns one column of coefficients per coordinate.
  Eigen::MatrixX3d solved(const std::vector<VertexPull>& pulls) const {
    const auto count = static_cast<Eigen::Index>(pulls.size()), rank = functions_.cols();
    Eigen::MatrixXd at_pulls(count, rank);
    for (Eigen::Index i = 0; i < count; ++i) at_pulls.row(i) = functions_.row(pulls[i].vertex);
    Eigen::MatrixXd hessian(3 * rank, 3 * rank), weighted(count, rank);
    Eigen::VectorXd right(3 * rank);
    for (Eigen::Index a = 0; a < 3; ++a) {
      Eigen::VectorXd goal(count);
      for (Eigen::Index i = 0; i < count; ++i) goal[i] = pulls[i].weighted_shift[a];
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
  PriorForm prior_;
};

}  // namespace

std::vector<Vec3> deform_template(const Mesh& surface, const Eigen::MatrixXd& functions, const Mesh& shape,
                                  const RunContext& ctx, const DeformTemplateOptions& options,
                                  std::span<const Vec3> start, const DisplacementPrior& prior) {
  check(surface, functions, options, start);
  const Fit fit(surface, functions, prior);
  Mesh bent = start.empty() ? surface : surface.with_positions({start.begin(), start.end()});
  const TwoWayMatches matches(surface, shape, options.match);
  for (const double noise : options.noise_mm)
    for (int k = 0; k < options.iterations; ++k) {
      ctx.check();
      bent = fit.fitted(matches.pulls(bent, noise));
    }
  return {bent.positions().begin(), bent.positions().end()};
}

}  // namespace foramen
