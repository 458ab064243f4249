#pragma once
/// \file
/// Private to stages: an aligned cohort's model as bytes, to be kept.

#include <utility>

#include "foramen/core/byte_archive.hpp"
#include "foramen/evaluate/generalization.hpp"

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

template <class Archive>
void transfer(Archive& archive, MaybeConst<RefitGeneralization::Failure> auto& f) {
  archive(f.shape, f.without, f.reason);
}

}  // namespace foramen
