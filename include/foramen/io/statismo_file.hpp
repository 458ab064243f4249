#pragma once
/// \file
/// Shape models in the layout of statismo 0.9: as HDF5, which statismo and Scalismo read, or the same
/// contents as JSON (model.h5.json), which Scalismo reads and writes.

#include <array>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "foramen/core/mesh.hpp"

namespace foramen {

/// What such a file holds of a point distribution model x = mean + basis * diag(sqrt(variance)) * s, s ~ N(0,
/// 1), over a triangle mesh. P points, T triangles, K modes, N training shapes.
struct StatismoModel {
  std::vector<Vec3> points;  ///< P, the reference mesh: any shape in correspondence, usually the mean, mm
  std::vector<std::array<int, 3>> triangles;  ///< T
  Eigen::VectorXd mean;                       ///< 3P: x0 y0 z0 x1 ..., mm
  Eigen::MatrixXd basis;                      ///< 3P x K, orthonormal columns
  Eigen::VectorXd variance;                   ///< K, mm^2, of the covariance with divisor N - 1
  /// P, > 0, or empty: what each landmark counts for in modes other than these. The layout has no place for
  /// it: /foramen/landmarkWeights, which other readers do not look at.
  std::vector<double> landmark_weights;
  double noise_variance = 0;  ///< mm^2
  Eigen::MatrixXd scores;     ///< K x N, in standard deviations, a column per shape; may be empty (0 x 0)
  std::vector<std::string> shape_uris;  ///< N, or empty: file names of the training shapes
  std::string build_time = "1970-01-01T00:00:00Z";
  std::string builder_name = "foramen";
  std::vector<std::pair<std::string, std::string>> parameters;  ///< unique keys without '/'
};

/// Writes single precision (other readers insist on it), whole or not at all; the same model gives the same
/// bytes. JSON if the name ends in .json, HDF5 otherwise. It should be .h5.json or .h5: Scalismo reads no
/// other. Throws InvalidInput if sizes do not agree, a value is not finite or a corner does not exist;
/// IoError.
void write_statismo(const std::filesystem::path& path, const StatismoModel& model);

/// The model that read_statismo() gives back of one that is written: its numbers have single precision.
StatismoModel in_single_precision(StatismoModel model);

/// Reads version 0.9 and 1.x of a triangle-mesh model, as JSON if the name ends in .json. Throws IoError
/// naming file, dataset and what is wrong with it: missing, of another shape, not finite, negative variances,
/// a basis whose columns are not orthonormal (1e-3), weights that are not positive.
StatismoModel read_statismo(const std::filesystem::path& path);

}  // namespace foramen
