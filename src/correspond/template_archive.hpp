#pragma once
/// \file
/// Private to correspond: results that depend on all shapes of a group as bytes (byte_archive.hpp), for the
/// store.
///
/// A PreparedTemplate is larger than its TemplateSurface and quickly computed from it, so only the surface is
/// stored.

#include "correspond/cohort_prior.hpp"
#include "correspond/mean_template.hpp"
#include "correspond/registered_archive.hpp"
#include "foramen/correspond/registration_frame.hpp"
#include "model/model_archive.hpp"

namespace foramen {

template <class Archive>
void transfer(Archive& archive, MaybeConst<TemplateSurface> auto& surface) {
  archive(surface.mesh, surface.map, surface.curvatures);
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
