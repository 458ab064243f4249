#include "foramen/model/procrustes.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <Eigen/LU>
#include <Eigen/SVD>

#include "foramen/core/error.hpp"

namespace foramen {
namespace {

constexpr double mean_tolerance = 1e-10;  // of the mean shape's size
// Usually fewer than ten are needed; nearly round shapes converge slowly.
constexpr int iteration_limit = 1000;

double weight_of(std::span<const double> weights, std::size_t i) {
  return weights.empty() ? 1.0 : weights[i];
}

void check_weights(std::span<const double> weights, std::size_t landmarks) {
  if (weights.empty()) return;
  if (weights.size() != landmarks)
    throw InvalidInput("found " + std::to_string(weights.size()) + " weights for " +
                       std::to_string(landmarks) + " landmarks: give one per landmark, or none");
  double sum = 0;
  for (const double w : weights) {
    if (!(w >= 0) || !std::isfinite(w))
      throw InvalidInput("found the landmark weight " + std::to_string(w) +
                         ": weights must be finite and >= 0");
    sum += w;
  }
  if (!(sum > 0)) throw InvalidInput("all landmark weights are zero: give at least one positive weight");
}

void check_points(std::span<const Vec3> points, const std::string& what) {
  if (points.empty()) throw InvalidInput(what + " has no landmarks");
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!points[i].allFinite())
      throw InvalidInput(what + ": landmark " + std::to_string(i) + " has a coordinate that is not finite");
}

Vec3 centroid(std::span<const Vec3> points, std::span<const double> weights) {
  Vec3 sum = Vec3::Zero();
  double total = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double w = weight_of(weights, i);
    sum += w * points[i];
    total += w;
  }
  return sum / total;
}

/// Root of the weighted sum of squared distances from `centre`.
double centroid_size(std::span<const Vec3> points, const Vec3& centre, std::span<const double> weights) {
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    sum += weight_of(weights, i) * (points[i] - centre).squaredNorm();
  return std::sqrt(sum);
}

/// The proper rotation R that maximises sum_i w_i f_i . R m_i for points given relative to their centres.
Mat3 best_rotation(std::span<const Vec3> moving, const Vec3& moving_centre, std::span<const Vec3> fixed,
                   const Vec3& fixed_centre, std::span<const double> weights) {
  Mat3 h = Mat3::Zero();
  for (std::size_t i = 0; i < moving.size(); ++i)
    h += weight_of(weights, i) * (moving[i] - moving_centre) * (fixed[i] - fixed_centre).transpose();
  const Eigen::JacobiSVD<Mat3> svd(h, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Mat3 &u = svd.matrixU(), &v = svd.matrixV();
  // If the unconstrained optimum is a reflection, the best rotation flips the axis of the smallest singular
  // value.
  const double handedness = (v * u.transpose()).determinant() < 0 ? -1.0 : 1.0;
  return v * Vec3(1, 1, handedness).asDiagonal() * u.transpose();
}

std::vector<Vec3> moved(std::span<const Vec3> points, const SimilarityTransform& transform) {
  std::vector<Vec3> out;
  out.reserve(points.size());
  for (const Vec3& p : points) out.push_back(transform(p));
  return out;
}

std::vector<Vec3> average(const std::vector<std::vector<Vec3>>& shapes) {
  std::vector<Vec3> mean(shapes[0].size(), Vec3::Zero());
  for (const auto& shape : shapes)
    for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += shape[i];
  for (Vec3& p : mean) p /= static_cast<double>(shapes.size());
  return mean;
}

/// RMS distance of corresponding points relative to the size of `b`.
double relative_change(std::span<const Vec3> a, std::span<const Vec3> b, std::span<const double> weights) {
  double moved_by = 0, size = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    moved_by += weight_of(weights, i) * (a[i] - b[i]).squaredNorm();
    size += weight_of(weights, i) * b[i].squaredNorm();
  }
  return std::sqrt(moved_by / size);
}

void check_shapes(const std::vector<std::vector<Vec3>>& shapes) {
  if (shapes.empty()) throw InvalidInput("there are no shapes to align");
  for (std::size_t s = 0; s < shapes.size(); ++s) {
    check_points(shapes[s], "shape " + std::to_string(s));
    if (shapes[s].size() != shapes[0].size())
      throw InvalidInput("shape " + std::to_string(s) + " has " + std::to_string(shapes[s].size()) +
                         " landmarks, shape 0 has " + std::to_string(shapes[0].size()) +
                         ": corresponding shapes must have the same number");
  }
}

/// Transforms that centre each shape and, with ScaleMode::remove, scale it; they do not rotate.
std::vector<SimilarityTransform> centred(const std::vector<std::vector<Vec3>>& shapes, ScaleMode scale,
                                         std::span<const double> weights) {
  std::vector<SimilarityTransform> transforms(shapes.size());
  std::vector<double> sizes(shapes.size());
  double average_size = 0;
  for (std::size_t s = 0; s < shapes.size(); ++s) {
    const Vec3 centre = centroid(shapes[s], weights);
    transforms[s].translation = -centre;
    sizes[s] = centroid_size(shapes[s], centre, weights);
    if (!(sizes[s] > 0))
      throw InvalidInput("shape " + std::to_string(s) + ": all landmarks are the same point, it has no size");
    average_size += sizes[s] / static_cast<double>(shapes.size());
  }
  if (scale == ScaleMode::remove)
    for (std::size_t s = 0; s < shapes.size(); ++s) {
      transforms[s].scale = average_size / sizes[s];
      transforms[s].translation *= transforms[s].scale;
    }
  return transforms;
}

/// Turns a transform by a further rotation about the origin.
void turn(SimilarityTransform& transform, const Mat3& rotation) {
  transform.rotation = rotation * transform.rotation;
  transform.translation = rotation * transform.translation;
}

}  // namespace

SimilarityTransform SimilarityTransform::inverse() const {
  SimilarityTransform back;
  back.scale = 1 / scale;
  back.rotation = rotation.transpose();
  back.translation = -(back.scale * (back.rotation * translation));
  return back;
}

Eigen::Matrix4d SimilarityTransform::matrix() const {
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  m.topLeftCorner<3, 3>() = scale * rotation;
  m.topRightCorner<3, 1>() = translation;
  return m;
}

SimilarityTransform fit_similarity(std::span<const Vec3> moving, std::span<const Vec3> fixed, ScaleMode scale,
                                   std::span<const double> weights) {
  check_points(moving, "the moving shape");
  check_points(fixed, "the fixed shape");
  if (moving.size() != fixed.size())
    throw InvalidInput("the moving shape has " + std::to_string(moving.size()) +
                       " landmarks, the fixed one " + std::to_string(fixed.size()) +
                       ": they must correspond one to one");
  check_weights(weights, moving.size());
  const Vec3 from = centroid(moving, weights), to = centroid(fixed, weights);
  SimilarityTransform fit;
  fit.rotation = best_rotation(moving, from, fixed, to, weights);
  if (scale == ScaleMode::remove) {
    const double size = centroid_size(moving, from, weights);
    if (!(size > 0)) throw InvalidInput("the moving shape has no size: no scale can be fitted");
    double along = 0;
    for (std::size_t i = 0; i < moving.size(); ++i)
      along += weight_of(weights, i) * (fixed[i] - to).dot(fit.rotation * (moving[i] - from));
    fit.scale = along / (size * size);
    if (!(fit.scale > 0))
      throw InvalidInput("the best scale is not positive: the two shapes do not resemble each other");
  }
  fit.translation = to - fit.scale * (fit.rotation * from);
  return fit;
}

ProcrustesResult procrustes(const std::vector<std::vector<Vec3>>& shapes, ScaleMode scale,
                            std::span<const double> weights) {
  check_shapes(shapes);
  check_weights(weights, shapes[0].size());
  ProcrustesResult result;
  result.transforms = centred(shapes, scale, weights);
  for (std::size_t s = 0; s < shapes.size(); ++s)
    result.aligned.push_back(moved(shapes[s], result.transforms[s]));

  const Vec3 origin = Vec3::Zero();
  result.mean = result.aligned[0];
  while (!result.converged && result.iterations < iteration_limit) {
    ++result.iterations;
    for (std::size_t s = 0; s < shapes.size(); ++s) {
      turn(result.transforms[s], best_rotation(result.aligned[s], origin, result.mean, origin, weights));
      result.aligned[s] = moved(shapes[s], result.transforms[s]);
    }
    std::vector<Vec3> next = average(result.aligned);
    result.converged = relative_change(next, result.mean, weights) < mean_tolerance;
    result.mean = std::move(next);
  }

  // All shapes are rotated back so that the first keeps its orientation. Products of many rotations have lost
  // orthonormality by rounding, so each rotation is normalised.
  const Mat3 back = result.transforms[0].rotation.transpose();
  for (std::size_t s = 0; s < shapes.size(); ++s) {
    SimilarityTransform& t = result.transforms[s];
    turn(t, back);
    t.rotation = s == 0 ? Mat3(Mat3::Identity()) : Mat3(Eigen::Quaterniond(t.rotation).normalized());
    t.translation = -t.scale * (t.rotation * centroid(shapes[s], weights));
    result.aligned[s] = moved(shapes[s], t);
  }
  result.mean = average(result.aligned);
  return result;
}

SimilarityTransform align_to_mean(std::span<const Vec3> shape, const ProcrustesResult& cohort,
                                  ScaleMode scale, std::span<const double> weights) {
  SimilarityTransform fit = fit_similarity(shape, cohort.mean, ScaleMode::keep, weights);
  if (scale == ScaleMode::keep) return fit;
  const double size = centroid_size(shape, centroid(shape, weights), weights);
  if (!(size > 0)) throw InvalidInput("all landmarks of the shape are the same point, it has no size");
  const Vec3 mean_centre = centroid(cohort.mean, weights);
  fit.scale = centroid_size(cohort.aligned[0], Vec3::Zero(), weights) / size;
  fit.translation = mean_centre - fit.scale * (fit.rotation * centroid(shape, weights));
  return fit;
}

}  // namespace foramen
