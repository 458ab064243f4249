#pragma once
/// \file
/// Cohorts of smoothly deformed tori in true correspondence, posed at random.

#include <array>
#include <cmath>
#include <string>

#include "foramen/core/geometry.hpp"
#include "foramen/evaluate/cohort.hpp"
#include "support/meshes.hpp"

namespace foramen::testing {

struct TorusCohortOptions {
  int shapes = 5;
  int input_around = 41, input_tube = 17;       ///< quads of the input surfaces
  int landmark_around = 20, landmark_tube = 8;  ///< quads of the corresponding meshes
  int shapes_per_subject = 2;
  double amplitude_mm = 2.0;  ///< amplitude of each wave that displaces a coordinate
  std::uint64_t seed = 1;
};

/// A smooth displacement of space, with a few random plane waves per coordinate.
class SmoothDisplacement {
 public:
  SmoothDisplacement(double amplitude, double wavelength, Rng rng) {
    for (Wave& w : waves_) {
      w.frequency = 2 * std::numbers::pi / wavelength * Vec3(rng.normal(), rng.normal(), rng.normal());
      w.phase = rng.uniform(0, 2 * std::numbers::pi);
      w.shift = amplitude * Vec3(rng.normal(), rng.normal(), rng.normal());
    }
  }
  Vec3 operator()(const Vec3& p) const {
    Vec3 moved = p;
    for (const Wave& w : waves_) moved += std::sin(w.frequency.dot(p) + w.phase) * w.shift;
    return moved;
  }

 private:
  struct Wave {
    Vec3 frequency, shift;
    double phase;
  };
  std::array<Wave, 5> waves_;
};

inline RigidTransform random_pose(Rng& rng) {
  RigidTransform pose = RigidTransform::Identity();
  pose.linear() = Eigen::Quaterniond(rng.normal(), rng.normal(), rng.normal(), rng.normal())
                      .normalized()
                      .toRotationMatrix();
  pose.translation() = 50 * Vec3(rng.normal(), rng.normal(), rng.normal());
  return pose;
}

/// A cohort whose landmarks and inputs are deformed in the same way. The inputs have their own, finer
/// triangulation.
inline CorrespondingCohort torus_cohort(const TorusCohortOptions& options = {}) {
  constexpr double major_mm = 30, minor_mm = 10, wavelength_mm = 90;
  const TriangleSoup fine = torus_soup(options.input_around, options.input_tube, major_mm, minor_mm);
  const TriangleSoup coarse = torus_soup(options.landmark_around, options.landmark_tube, major_mm, minor_mm);
  CorrespondingCohort cohort;
  cohort.triangles = coarse.triangles;
  for (int s = 0; s < options.shapes; ++s) {
    Rng rng = Rng(options.seed).fork(static_cast<std::uint64_t>(s));
    const SmoothDisplacement deform(options.amplitude_mm, wavelength_mm, rng.fork(0));
    const RigidTransform pose = random_pose(rng);
    TriangleSoup input = fine;
    std::vector<Vec3> landmarks = coarse.points;
    for (Vec3& p : input.points) p = pose * deform(p);
    for (Vec3& p : landmarks) p = pose * deform(p);
    const int subject = s / options.shapes_per_subject;
    cohort.names.push_back("patient" + std::to_string(subject) + "_" + std::to_string(s));
    cohort.subjects.push_back("patient" + std::to_string(subject));
    cohort.corresponding.push_back(std::move(landmarks));
    cohort.inputs.push_back(build_mesh(std::move(input)));
  }
  return cohort;
}

}  // namespace foramen::testing
