#pragma once
/// \file
/// Alignments and models as bytes (byte_archive.hpp), to be kept.

#include <utility>

#include "core/byte_archive.hpp"
#include "foramen/model/build_shape_model.hpp"

namespace foramen {

template <class Archive>
void transfer(Archive& archive, MaybeConst<SimilarityTransform> auto& t) {
  archive(t.scale, t.rotation, t.translation);
}

template <class Archive>
void transfer(Archive& archive, MaybeConst<ProcrustesResult> auto& p) {
  archive(p.transforms, p.aligned, p.mean, p.iterations, p.converged);
}

inline void transfer(ByteWriter& archive, const ShapeModel& m) {
  archive(m.mean(), m.basis(), m.variance(), m.triangles(), m.weights());
}
inline void transfer(ByteReader& archive, ShapeModel& model) {
  Eigen::VectorXd mean, variance;
  Eigen::MatrixXd basis;
  std::vector<std::array<int, 3>> triangles;
  std::vector<double> weights;
  archive(mean, basis, variance, triangles, weights);
  model = ShapeModel(std::move(mean), std::move(basis), std::move(variance), std::move(triangles),
                     std::move(weights));
}

template <class Archive>
void transfer(Archive& archive, MaybeConst<AlignedModel> auto& m) {
  archive(m.alignment, m.model);
}

}  // namespace foramen
