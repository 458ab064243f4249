#pragma once
/// \file
/// Private to evaluate: errors as bytes, for the store.

#include "core/byte_archive.hpp"
#include "foramen/evaluate/cohort.hpp"

namespace foramen {

template <class Archive>
void transfer(Archive& archive, MaybeConst<ShapeError> auto& error) {
  archive(error.hausdorff, error.mean_surface, error.landmark_rms);
}

}  // namespace foramen
