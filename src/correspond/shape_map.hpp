#pragma once
/// \file
/// The final map of a shape to the torus, with its certificate and statistics.

#include "foramen/correspond/registration_frame.hpp"
#include "foramen/parameterize/torus_map.hpp"
#include "parameterize/optimise_map.hpp"

namespace foramen {

/// The final map of the input mesh: wrapped, quantised and certified. Throws ConvergenceError if it is not
/// one to one.
/// \param working  result of the optimisation on the working mesh
/// \param full  result of the optimisation on the input mesh, whose map is taken
ShapeMap certified(const Mesh& input, const OptimisedMap& working, const OptimisedMap& full);

/// Throws ConvergenceError if the optimisation ended at its iteration limit.
/// \param which  name of the mesh for the message: "working" or "input"
void require_converged(const OptimisedMap& result, const char* which);

}  // namespace foramen
