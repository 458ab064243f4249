#pragma once
/// \file
/// A shape's final map to the torus, with what is known about it.

#include "foramen/parameterize/certificate.hpp"
#include "foramen/parameterize/optimise_map.hpp"

namespace foramen {

struct ShapeMap {
  TorusMap map;  ///< of the input mesh, positions quantised, in the reference's basis and lattice
  MapCertificate certificate;                   ///< of that map
  int iterations = 0;                           ///< on the working mesh and on the input mesh together
  double initial_energy = 0, final_energy = 0;  ///< on the working mesh, then on the input mesh
  double distortion = 0;                        ///< area-weighted mean of Degener's energy, >= 4
};

/// The map of the input mesh as it is kept: wrapped, quantised, certified. Throws ConvergenceError if it is
/// not one to one. \param working, full  the two searches that led to it; the map is the second's
ShapeMap certified(const Mesh& input, const OptimisedMap& working, const OptimisedMap& full);

/// Throws ConvergenceError if the search ended at its limit of iterations. \param which  mesh: "working" or
/// "input"
void require_converged(const OptimisedMap& result, const char* which);

}  // namespace foramen
