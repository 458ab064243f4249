#pragma once
/// \file
/// A shape's final map to the torus, with what is known about it.

#include "foramen/correspond/registration_frame.hpp"
#include "foramen/parameterize/certificate.hpp"
#include "parameterize/optimise_map.hpp"

namespace foramen {

/// The map of the input mesh as it is kept: wrapped, quantised, certified. Throws ConvergenceError if it is
/// not one to one. \param working, full  the two searches that led to it; the map is the second's
ShapeMap certified(const Mesh& input, const OptimisedMap& working, const OptimisedMap& full);

/// Throws ConvergenceError if the search ended at its limit of iterations. \param which  mesh: "working" or
/// "input"
void require_converged(const OptimisedMap& result, const char* which);

}  // namespace foramen
