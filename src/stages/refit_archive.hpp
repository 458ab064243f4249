#pragma once
/// \file
/// Private to stages: why a shape has no part in a refit, as bytes, to be kept.

#include "foramen/core/byte_archive.hpp"
#include "foramen/stages/refit.hpp"

namespace foramen {

template <class Archive>
void transfer(Archive& archive, MaybeConst<RefitGeneralization::Failure> auto& f) {
  archive(f.shape, f.without, f.reason);
}

}  // namespace foramen
