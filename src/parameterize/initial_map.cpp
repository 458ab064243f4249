#include "parameterize/initial_map.hpp"

#include <string>

#include "foramen/core/error.hpp"
#include "parameterize/periodic_laplacian.hpp"

namespace foramen {

TorusMap harmonic_torus_map(const Mesh& mesh, const Cocycle& form) {
  VertexMap<std::optional<Vec2>> fixed(mesh.vertex_count());
  fixed[VertexId(0)] = Vec2::Zero();
  TorusMap map{Lattice::Identity(), average_of_neighbours(mesh, form, fixed), form.value};
  check_embedding(mesh, map);
  return map;
}

}  // namespace foramen
