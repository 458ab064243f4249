#pragma once
/// \file
/// Private to stages: the reason why a shape failed in a refit as bytes, for the store.

#include "core/byte_archive.hpp"
#include "foramen/stages/refit.hpp"

namespace foramen {

template <class Archive>
void transfer(Archive& archive, MaybeConst<RefitGeneralization::Failure> auto& f) {
  archive(f.shape, f.without, f.reason);
}

}  // namespace foramen
