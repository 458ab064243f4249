#pragma once
/// \file
/// The data to which the shapes of a cohort were registered and to which a further shape is registered.

#include <vector>

#include "foramen/match/displacement_prior.hpp"
#include "foramen/parameterize/torus_map.hpp"
#include "foramen/topology/shortest_loops.hpp"

namespace foramen {

/// The final map of a shape to the torus, with its certificate and statistics.
struct ShapeMap {
  TorusMap map;  ///< map of the input mesh, quantised, in the basis and lattice of the reference
  MapCertificate certificate;  ///< certificate of this map
  int iterations = 0;          ///< total on the working mesh and the input mesh
  /// At the start on the working mesh; at the end on the input mesh.
  double initial_energy = 0, final_energy = 0;
  double distortion = 0;  ///< area-weighted mean of Degener's energy, >= 4
};

/// The loops of the reference, to which the loops of the other shapes are compared.
struct ReferenceLoops {
  Mesh mesh;                ///< the reference, in its own coordinates
  LoopSystem loops;         ///< two loops, oriented so that a torus map with their periods has positive area
  Eigen::Matrix2i seifert;  ///< see seifert_matrix()
};

/// The reference shape: its loops and its map to the torus.
struct Reference {
  ReferenceLoops loops;  ///< the loops and the mesh
  ShapeMap shape_map;
  const Mesh& mesh() const { return loops.mesh; }
};

/// The reference or the mean of a cohort, as a template.
struct TemplateSurface {
  Mesh mesh;     ///< mm
  TorusMap map;  ///< map of this mesh, without flipped triangles
  /// Per vertex: (tanh(k1 / k0), tanh(k2 / k0)) with the principal curvatures and k0 = 0.3 / mm, which the
  /// shapes' curvatures shall agree with. Empty: those of this mesh. A coarse mesh has those of a fine one.
  VertexMap<Vec2> curvatures = {};
};

/// The template of the last round, to which all shapes are registered.
struct GroupTemplate {
  /// Number of rounds with a mean as template; 0: only the reference was a template, and the fields below are
  /// empty.
  int rounds = 0;
  TemplateSurface surface;  ///< see MeanTemplate
  std::vector<Vec3> grid;   ///< see MeanTemplate
  DisplacementPrior prior;  ///< prior of the displacement onto a new shape, see CohortPriors
};

/// The data to which a further shape is registered.
struct RegistrationFrame {
  Reference reference;  ///< the reference with its final map
  GroupTemplate group;  ///< for Objective::surface
};

}  // namespace foramen
