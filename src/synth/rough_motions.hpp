#pragma once
/// \file
/// How single features of a vertebra vary in a rough cohort, each by its own law.

#include "foramen/core/rng.hpp"
#include "synth/local_motion.hpp"

namespace foramen::synth {

/// The random local motions of one shape, in the frame of the template:
/// - each process grows or shrinks along its axis and tilts about its base,
/// - each facet slides in its plane, turns about two axes and grows,
/// - each endplate rim moves outward and upward by a random Fourier series of its angle,
/// - two to seven spurs grow on rims and facet margins.
///
/// Left and right processes and facets are correlated, and so are the two halves of a rim. Spurs are not.
LocalMotions rough_motions(Rng& rng);

}  // namespace foramen::synth
