#include "foramen/match/displacement_prior.hpp"

#include <string>

#include <Eigen/Cholesky>

#include "foramen/core/error.hpp"

namespace foramen {

PriorForm prior_form(const DisplacementPrior& prior, Eigen::Index coefficients) {
  const auto refuse = [](const std::string& what) { throw InvalidInput("displacement prior: " + what); };
  if (!(prior.variance > 0)) refuse("variance must be > 0");
  const Eigen::MatrixXd& d = prior.directions;
  if ((prior.mean.size() > 0 && prior.mean.size() != coefficients) ||
      (d.size() > 0 && d.rows() != coefficients))
    refuse("mean and directions must have " + std::to_string(coefficients) + " coefficients");

  const double v = prior.variance;
  PriorForm form;
  form.precision = Eigen::MatrixXd::Identity(coefficients, coefficients) / v;
  if (d.size() > 0) {
    // Woodbury: (v I + D D^T)^-1 = (I - D (v I + D^T D)^-1 D^T) / v
    Eigen::MatrixXd inner = d.transpose() * d;
    inner.diagonal().array() += v;
    const Eigen::MatrixXd half = inner.llt().matrixL().solve(d.transpose());
    form.precision.noalias() -= half.transpose() * half / v;
  }
  form.pull = Eigen::VectorXd::Zero(coefficients);
  if (prior.mean.size() > 0) form.pull.noalias() = form.precision * prior.mean;
  return form;
}

}  // namespace foramen
