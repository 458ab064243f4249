#pragma once
/// \file
/// Shapes with known torus maps, on which coarse landmark triangles are flipped or intersect.

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "foramen/sampling/landmark_mesh.hpp"
#include "sampling/curvature_density.hpp"
#include "sampling/lift_to_surface.hpp"
#include "sampling/mapped_tori.hpp"
#include "sampling/refine_landmarks.hpp"
#include "sampling/remesh.hpp"
#include "spatial/flips.hpp"
#include "spatial/self_intersections.hpp"

namespace foramen::testing {

/// Shapes with the data that is needed to lift and check landmarks. The locators and trees refer to the
/// surfaces of the same object.
struct MappedCohort {
  std::vector<MappedSurface> surfaces;
  std::vector<TorusLocator> locators;
  std::vector<TriangleTree> trees;
  explicit MappedCohort(std::vector<MappedSurface> of) : surfaces(std::move(of)) {
    for (const auto& s : surfaces) {
      locators.emplace_back(s.mesh, s.map);
      trees.emplace_back(s.mesh);
    }
  }
  std::vector<LandmarkShape> shapes() const {
    std::vector<LandmarkShape> out;
    for (std::size_t i = 0; i < surfaces.size(); ++i) out.push_back({&locators[i], &trees[i]});
    return out;
  }
  int guilty(const LandmarkMesh& l) const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
      const auto f =
          sampled_flips(build_mesh({lift_to_surface(locators[i], l.turns), l.triangles}), trees[i]);
      count += f.confirmed.size() + f.degenerate.size();
    }
    return static_cast<int>(count);
  }
  int meetings(const LandmarkMesh& l) const {
    std::size_t count = 0;
    for (const TorusLocator& locator : locators)
      count += self_intersections(TriangleTree(build_mesh({lift_to_surface(locator, l.turns), l.triangles})))
                   .size();
    return static_cast<int>(count);
  }
};

/// A torus whose tube, which is 16 mm high, is flattened in one place to a bent wall of thickness 2 *
/// half_wall_mm.
inline MappedSurface walled_torus(double half_wall_mm, double middle_turns, double width_turns) {
  return mapped_surface("walled torus", rectangular_lattice(20, 8), 20000, [=](const Vec2& t) {
    const double x = std::remainder(t.x() - middle_turns, 1.0) / width_turns;
    const double across = 3 - (3 - half_wall_mm) * std::exp(-x * x / 2);
    const Vec2 a = 2 * std::numbers::pi * t;
    const double r = 20 + across * std::cos(a.y());
    return Vec3(r * std::cos(a.x()), r * std::sin(a.x()), 8 * std::sin(a.y()));
  });
}

inline MappedSurface spikes() { return spiky_torus(20000, 6, 14, 0.02); }

inline LandmarkMesh landmarks_of(const MappedSurface& m, int count) {
  return remesh(m.mesh, m.map, curvature_density(m.mesh), RunContext(1), {.landmarks = count});
}

/// Three copies of the spiky torus whose maps are deformed in different ways. Landmarks that suit the
/// original map miss the thin tips.
inline MappedCohort bent_spikes(double strength) {
  std::vector<MappedSurface> out;
  for (int k = 0; k < 3; ++k) {
    out.push_back(spikes());
    TorusMap& map = out.back().map;
    for (Vec2& t : map.turns) {
      const Vec2 a = 2 * std::numbers::pi * t;
      t += strength * Vec2(std::sin(3 * a.y() + k), std::sin(2 * a.x() + 2 * a.y() + 2 * k));
    }
    map = quantised(out.back().mesh, map);
  }
  return MappedCohort(std::move(out));
}

}  // namespace foramen::testing
