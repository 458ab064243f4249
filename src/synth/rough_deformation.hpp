#pragma once
/// \file
/// What makes a rough cohort rough: the anatomy of one shape below the scale of the smooth deformation, its
/// number of vertices and the noise of its segmentation.

#include <span>
#include <vector>

#include "foramen/core/mesh.hpp"
#include "foramen/core/rng.hpp"
#include "synth/local_motion.hpp"
#include "synth/random_flow.hpp"

namespace foramen::synth {

/// A diffeomorphism of the template's space: first the local motions of features (rough_motions()), then the
/// flows of random fields, from fine to coarse.
class RoughDeformation {
 public:
  explicit RoughDeformation(Rng& rng);
  std::vector<Vec3> carried(std::span<const Vec3> points) const;

 private:
  struct Flow {
    VelocityField field;
    int steps;
  };
  LocalMotions motions_;
  std::vector<Flow> flows_;
};

/// A number of vertices between 0.6 and 1.6 times `vertices`, its logarithm uniformly distributed.
int rough_vertex_count(int vertices, Rng& rng);

/// Moves the vertices along their normals by a random function of space with a correlation length of 2 mm and
/// a standard deviation of 0.12 mm, like the noise of a segmentation.
void add_segmentation_noise(TriangleSoup& surface, Rng& rng);

}  // namespace foramen::synth
