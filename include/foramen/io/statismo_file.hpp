#pragma once
/// \file
/// Shape models in the file layout of statismo 0.9, either as HDF5, which statismo and Scalismo read, or with
/// the same contents as JSON (model.h5.json), which Scalismo reads and writes.

#include <array>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "foramen/core/mesh.hpp"
#include "foramen/core/remedy.hpp"

namespace foramen {

/// The content of such a file: a point distribution model x = mean + basis * diag(sqrt(variance)) * s with s
/// ~ N(0, I), over a triangle mesh of P points and T triangles, with K modes and N training shapes.
struct StatismoModel {
  std::vector<Vec3> points;                   ///< P points of the reference mesh, usually the mean shape, mm
  std::vector<std::array<int, 3>> triangles;  ///< T
  Eigen::VectorXd mean;                       ///< 3P: x0 y0 z0 x1 ..., mm
  Eigen::MatrixXd basis;                      ///< 3P x K, orthonormal columns
  Eigen::VectorXd variance;                   ///< K variances of the modes, mm^2, with divisor N - 1
  /// P weights of the landmarks, > 0, or empty. foramen's own modes are orthonormal under these weights; the
  /// basis of this struct is orthonormal without them. statismo has no place for weights, so they stand in
  /// /foramen/landmarkWeights, which other readers ignore.
  std::vector<double> landmark_weights;
  double noise_variance = 0;  ///< mm^2
  /// K x N scores of the training shapes, in standard deviations; may be empty (0 x 0).
  Eigen::MatrixXd scores;
  std::vector<std::string> shape_uris;  ///< N, or empty: file names of the training shapes
  std::string build_time = "1970-01-01T00:00:00Z";
  std::string builder_name = "foramen";
  std::vector<std::pair<std::string, std::string>> parameters;  ///< unique keys without '/'
  std::vector<Message> notes;  ///< of the reader: what was changed; not written
};

/// Writes JSON if the name ends in .json, otherwise HDF5. The name should end in .h5.json or .h5, since
/// Scalismo reads no other. Numbers are in single precision, which other readers require. The file is written
/// completely or not at all, and the same model always gives the same bytes. Throws InvalidInput if sizes do
/// not agree, a value is not finite or a corner does not exist; IoError if the file cannot be written.
void write_statismo(const std::filesystem::path& path, const StatismoModel& model);

/// The model that read_statismo() gives back of one that is written: its numbers have single precision.
StatismoModel in_single_precision(StatismoModel model);

/// Reads a triangle-mesh model of version 0.9 or 1.x, as JSON if the name ends in .json. Columns of the basis
/// that are not orthonormal within 1e-3, as those of Gaussian processes, are replaced by the principal
/// components of the same covariance \f$ B\,\mathrm{diag}(v)\,B^T \f$, and a note says so; modes without
/// variance are then left out. Throws IoError with the file, the dataset and its fault: missing, of the wrong
/// shape, not finite, a negative variance, or weights that are not positive.
StatismoModel read_statismo(const std::filesystem::path& path);

}  // namespace foramen
