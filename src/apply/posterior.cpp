#include "apply/posterior.hpp"

#include <string>
#include <vector>

#include <Eigen/Cholesky>

#include "foramen/core/error.hpp"

namespace foramen {
namespace {

// All observations of one landmark combined.
struct Seen {
  Mat3 precision = Mat3::Zero();
  Vec3 pull = Vec3::Zero();  // sum of precision (place - mean)
};

}  // namespace

PosteriorCoefficients posterior_coefficients(const ShapeDistribution& prior,
                                             std::span<const LandmarkObservation> observations) {
  const Eigen::Index columns = prior.factor.cols();
  std::vector<Seen> seen(prior.landmarks());
  for (const LandmarkObservation& o : observations) {
    if (o.landmark < 0 || o.landmark >= prior.landmarks())
      throw InvalidInput("posterior_coefficients: landmark " + std::to_string(o.landmark) +
                         " was observed, but there are " + std::to_string(prior.landmarks()));
    Seen& at = seen[o.landmark];
    at.precision += o.precision;
    at.pull += o.precision * (o.place - prior.mean.segment<3>(3 * o.landmark));
  }
  Eigen::MatrixXd rows(prior.mean.size(), columns), weighted(prior.mean.size(), columns);
  Eigen::VectorXd pull(prior.mean.size());
  Eigen::Index used = 0;
  for (int i = 0; i < prior.landmarks(); ++i) {
    const Seen& at = seen[i];
    if (at.precision.isZero(0)) continue;
    rows.middleRows<3>(used) = prior.factor.middleRows<3>(3 * i);
    weighted.middleRows<3>(used).noalias() = at.precision * prior.factor.middleRows<3>(3 * i);
    pull.segment<3>(used) = at.pull;
    used += 3;
  }
  Eigen::MatrixXd m = Eigen::MatrixXd::Identity(columns, columns);
  m.triangularView<Eigen::Lower>() += rows.topRows(used).transpose() * weighted.topRows(used);
  const Eigen::LLT<Eigen::MatrixXd> cholesky(m.selfadjointView<Eigen::Lower>());
  FORAMEN_ASSERT(cholesky.info() == Eigen::Success);
  PosteriorCoefficients result;
  result.mean = cholesky.solve(rows.topRows(used).transpose() * pull.head(used));
  result.spread = cholesky.matrixU().solve(Eigen::MatrixXd::Identity(columns, columns));
  return result;
}

ShapeDistribution posterior(const ShapeDistribution& prior, const PosteriorCoefficients& coefficients) {
  return {prior.mean + prior.factor * coefficients.mean, prior.factor * coefficients.spread};
}

}  // namespace foramen
