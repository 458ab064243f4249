#include "correspond/shape_map.hpp"

#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "foramen/correspond/registration_frame.hpp"
#include "parameterize/mapped_torus.hpp"
#include "parameterize/optimise_map.hpp"

namespace foramen {
namespace {

using ::testing::HasSubstr;

OptimisedMap searched(OptimiseStatus status, int iterations, double initial, double final) {
  OptimisedMap result;
  result.status = status;
  result.iterations = iterations;
  result.initial_energy = initial;
  result.final_energy = final;
  return result;
}

template <class Work>
std::string failure(const Work& work) {
  try {
    work();
  } catch (const ConvergenceError& e) {
    return e.what();
  }
  return "";
}

class Certified : public ::testing::Test {
 protected:
  // The result of two searches that end with this map on the input mesh.
  ShapeMap certified_as(const TorusMap& map) const {
    OptimisedMap full = searched(OptimiseStatus::converged, 2, 6, 5);
    full.map = map;
    full.distortion = 4.5;
    return certified(torus_.mesh, searched(OptimiseStatus::converged, 3, 10, 7), full);
  }
  const testing::MappedTorus torus_ = testing::mapped_bumpy_torus(24, 10, 3);
};

TEST_F(Certified, ReportsBothSearchesAndHoldsTheMapOfTheSecond) {
  const ShapeMap result = certified_as(torus_.map);
  EXPECT_EQ(result.iterations, 5);
  EXPECT_EQ(result.initial_energy, 10);
  EXPECT_EQ(result.final_energy, 5);
  EXPECT_EQ(result.distortion, 4.5);
  EXPECT_TRUE(result.certificate.valid());
  EXPECT_EQ(result.certificate.triangles, torus_.mesh.face_count());
  EXPECT_EQ(result.map.lattice, torus_.map.lattice);
}

TEST_F(Certified, PositionsAreWrappedAndQuantised) {
  TorusMap moved = torus_.map;
  for (Vec2& t : moved.turns) t += Vec2(2.3, -1.0 / 3);
  const ShapeMap result = certified_as(moved);
  for (const VertexId v : torus_.mesh.vertices()) {
    const Vec2 t = result.map.turns[v];
    for (const double x : t) {
      EXPECT_GE(x, 0);
      EXPECT_LT(x, 1);
      EXPECT_EQ(std::ldexp(x, quantum_bits), std::round(std::ldexp(x, quantum_bits)));
    }
    const Vec2 apart = t - moved.turns[v];
    EXPECT_LT((apart.array() - apart.array().round()).matrix().norm(), 1e-11) << "the same place";
  }
}

TEST_F(Certified, AFlippedTriangleIsRefusedWithTheNumber) {
  TorusMap bad = torus_.map;
  const HalfedgeId h(0);
  // One end of an edge is moved across the other end, beyond the triangles there.
  const VertexId a = torus_.mesh.from(h), b = torus_.mesh.to(h);
  bad.turns[a] = bad.turns[b] + bad.jumps[h].cast<double>() +
                 0.7 * (bad.turns[b] + bad.jumps[h].cast<double>() - bad.turns[a]);
  int flipped = 0;
  for (const FaceId f : torus_.mesh.faces())
    if (!(signed_area(torus_.mesh, bad, f) > 0)) ++flipped;
  ASSERT_GT(flipped, 0);
  const std::string said = failure([&] { certified_as(bad); });
  EXPECT_THAT(said, HasSubstr("not one to one"));
  EXPECT_THAT(said, HasSubstr(": " + std::to_string(flipped) + " of its triangles"));
}

TEST(RequireConverged, OnlyALimitOfIterationsIsRefused) {
  EXPECT_NO_THROW(require_converged(searched(OptimiseStatus::converged, 200, 9, 8), "working"));
  // A line search stalls at the minimum, where rounding prevents further improvement.
  EXPECT_NO_THROW(require_converged(searched(OptimiseStatus::line_search_stalled, 17, 9, 8), "working"));
  const std::string said =
      failure([] { require_converged(searched(OptimiseStatus::iteration_limit, 200, 9, 8), "working"); });
  EXPECT_THAT(said, HasSubstr("working mesh"));
  EXPECT_THAT(said, HasSubstr("200 iterations"));
}

}  // namespace
}  // namespace foramen
