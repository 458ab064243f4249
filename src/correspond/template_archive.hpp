#pragma once
/// \file
/// Private to correspond: what all shapes of a group make together as bytes (byte_archive.hpp), to be kept.
///
/// A PreparedTemplate is larger than the TemplateSurface it is made of, and quickly made: only the surface is
/// kept.

#include "correspond/cohort_prior.hpp"
#include "correspond/mean_template.hpp"
#include "correspond/registered_archive.hpp"
#include "foramen/correspond/registration_frame.hpp"
#include "model/model_archive.hpp"

namespace foramen {

template <class Archive>
void transfer(Archive& archive, MaybeConst<TemplateSurface> auto& surface) {
  archive(surface.mesh, surface.map);
}

template <class Archive>
void transfer(Archive& archive, MaybeConst<MeanTemplate> auto& mean) {
  archive(mean.surface, mean.transforms, mean.grid);
}

template <class Archive>
void transfer(Archive& archive, MaybeConst<CohortPriors> auto& priors) {
  archive(priors.coefficients, priors.unexplained_share);
}

}  // namespace foramen
