#include "correspond/shape_map.hpp"

#include <string>

#include "foramen/core/error.hpp"

namespace foramen {

ShapeMap certified(const Mesh& input, const OptimisedMap& working, const OptimisedMap& full) {
  ShapeMap result;
  result.map = quantised(input, wrapped(input, full.map));
  result.certificate = certify(input, result.map);
  result.iterations = working.iterations + full.iterations;
  result.initial_energy = working.initial_energy;
  result.final_energy = full.final_energy;
  result.distortion = full.distortion;
  if (!result.certificate.valid())
    throw ConvergenceError("the final map is not one to one: " + std::to_string(result.certificate.flipped) +
                           " of its triangles are flipped or have no area");
  return result;
}

void require_converged(const OptimisedMap& result, const char* which) {
  if (result.status == OptimiseStatus::iteration_limit)
    throw ConvergenceError(std::string("the map of the ") + which + " mesh did not converge within " +
                           std::to_string(result.iterations) + " iterations");
}

}  // namespace foramen
