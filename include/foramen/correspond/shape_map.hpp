#pragma once
/// \file
/// The final map of a shape to the torus, with its certificate and statistics.

#include "foramen/parameterize/certificate.hpp"
#include "foramen/parameterize/optimise_map.hpp"

namespace foramen {

struct ShapeMap {
  TorusMap map;  ///< map of the input mesh, quantised, in the basis and lattice of the reference
  MapCertificate certificate;  ///< certificate of this map
  int iterations = 0;          ///< total on the working mesh and the input mesh
  /// At the start on the working mesh; at the end on the input mesh.
  double initial_energy = 0, final_energy = 0;
  double distortion = 0;  ///< area-weighted mean of Degener's energy, >= 4
};

/// The final map of the input mesh: wrapped, quantised and certified. Throws ConvergenceError if it is not
/// one to one.
/// \param working  result of the optimisation on the working mesh
/// \param full  result of the optimisation on the input mesh, whose map is taken
ShapeMap certified(const Mesh& input, const OptimisedMap& working, const OptimisedMap& full);

/// Throws ConvergenceError if the optimisation ended at its iteration limit.
/// \param which  name of the mesh for the message: "working" or "input"
void require_converged(const OptimisedMap& result, const char* which);

}  // namespace foramen
