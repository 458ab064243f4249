#pragma once
/// \file
/// What the shapes of a cohort were registered to, and what a further shape is registered to.

#include <vector>

#include "foramen/match/displacement_prior.hpp"
#include "foramen/parameterize/certificate.hpp"
#include "foramen/parameterize/torus_map.hpp"
#include "foramen/topology/shortest_loops.hpp"

namespace foramen {

struct ShapeMap {
  TorusMap map;  ///< of the input mesh, positions quantised, in the reference's basis and lattice
  MapCertificate certificate;                   ///< of that map
  int iterations = 0;                           ///< on the working mesh and on the input mesh together
  double initial_energy = 0, final_energy = 0;  ///< on the working mesh, then on the input mesh
  double distortion = 0;                        ///< area-weighted mean of Degener's energy, >= 4
};

/// The reference's loops as every other shape sees them.
struct ReferenceLoops {
  Mesh mesh;                ///< the reference, in its own coordinates
  LoopSystem loops;         ///< two, oriented so that the torus map they give has positive area
  Eigen::Matrix2i seifert;  ///< see seifert_matrix()
};

struct Reference {
  ReferenceLoops loops;  ///< with the mesh
  ShapeMap shape_map;
  const Mesh& mesh() const { return loops.mesh; }
};

/// A reference, or the mean of a cohort.
struct TemplateSurface {
  Mesh mesh;     ///< mm
  TorusMap map;  ///< of this mesh, without flipped triangles
};

/// What the last round registered all shapes to.
struct GroupTemplate {
  int rounds = 0;           ///< with a mean as template; 0: the reference was the only one, the rest is empty
  TemplateSurface surface;  ///< see MeanTemplate
  std::vector<Vec3> grid;   ///< see MeanTemplate
  DisplacementPrior prior;  ///< of a newcomer's displacement: see CohortPriors
};

/// What a further shape is registered to.
struct RegistrationFrame {
  Reference reference;  ///< with the map it ended with
  GroupTemplate group;  ///< of Objective::surface
};

}  // namespace foramen
