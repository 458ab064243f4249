#include "correspond/feature_targets.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "foramen/core/rng.hpp"
#include "sampling/mapped_tori.hpp"

namespace foramen {
namespace {

class Constant : public CorrespondenceObjective {
 public:
  Term term(VertexId, const Vec2&) const override { return {1, Vec2(2, 3), Mat2::Identity()}; }
};

class FeatureTargetsOnATorus : public ::testing::Test {
 protected:
  const testing::MappedSurface torus = testing::wavy_torus(1500);
  const TorusLocator locator{torus.mesh, torus.map};
  const FeatureTargetsOptions options{.weight_mm2 = 3, .robust_difference = 0.4, .radius_mm = 8};
  const VertexMap<Vec2> features = curvature_features(torus.mesh, options);
  const FeatureField field{{torus.mesh, torus.map}, features};
  const Constant further;

  FeatureTargets targets_at(const TorusMap& map) const {
    return {further, features, map, field, locator, options};
  }
  Vec2 place(VertexId v, const TorusMap& map) const { return map.lattice * map.turns[v]; }
};

TEST_F(FeatureTargetsOnATorus, TheFieldOfAVertexIsItsFeature) {
  for (VertexId v : torus.mesh.vertices())
    EXPECT_LT((field.at(locator, place(v, torus.map)).features - features[v]).norm(), 1e-6);
}

TEST_F(FeatureTargetsOnATorus, TheSlopesOfAWaveAreThoseOfTheFormula) {
  VertexMap<Vec2> waves(torus.mesh.vertex_count(), Vec2::Zero());
  constexpr double turn = 2 * std::numbers::pi;
  for (VertexId v : torus.mesh.vertices())
    waves[v] = {std::cos(turn * torus.map.turns[v].x()), std::sin(turn * torus.map.turns[v].y())};
  const FeatureField of_waves({torus.mesh, torus.map}, waves);
  Rng rng(1);
  for (int i = 0; i < 100; ++i) {
    const Vec2 turns(rng.uniform(), rng.uniform());
    const auto value = of_waves.at(locator, torus.map.lattice * turns);
    Mat2 by_turns;
    by_turns << -turn * std::sin(turn * turns.x()), 0, 0, turn * std::cos(turn * turns.y());
    const Mat2 expected = by_turns * torus.map.lattice.inverse();
    EXPECT_LT((value.slopes - expected).norm(), 0.1 * (turn * torus.map.lattice.inverse()).norm());
    EXPECT_NEAR(value.features.x(), std::cos(turn * turns.x()), 0.03);
    EXPECT_NEAR(value.features.y(), std::sin(turn * turns.y()), 0.03);
  }
}

TEST_F(FeatureTargetsOnATorus, NothingIsAddedWhereTheTemplateIsTheShape) {
  const FeatureTargets targets = targets_at(torus.map);
  for (VertexId v : torus.mesh.vertices()) {
    const auto term = targets.term(v, place(v, torus.map));
    EXPECT_NEAR(term.value, 1, 1e-9);
    EXPECT_LT((term.gradient - Vec2(2, 3)).norm(), 1e-4);
  }
}

// A map that is displaced everywhere by the same small vector is drawn back to where the features agree.
TEST_F(FeatureTargetsOnATorus, DrawADisplacedMapBack) {
  const Vec2 shift(0.004, 0.003);
  TorusMap displaced = torus.map;
  for (VertexId v : torus.mesh.vertices()) displaced.turns[v] += shift;
  const FeatureTargets targets = targets_at(displaced);
  Vec2 gradient = Vec2::Zero();
  Mat2 hessian = Mat2::Zero();
  for (VertexId v : torus.mesh.vertices()) {
    const auto term = targets.term(v, place(v, displaced));
    gradient += term.gradient - Vec2(2, 3);
    hessian += term.hessian - Mat2::Identity();
  }
  const Vec2 step = -hessian.inverse() * gradient, expected = -torus.map.lattice * shift;
  EXPECT_LT((step - expected).norm(), 0.25 * expected.norm());
}

TEST_F(FeatureTargetsOnATorus, AreAQuadraticOfTheShortestWayAndPeriodic) {
  const FeatureTargets targets = targets_at(torus.map);
  const VertexId v(700);
  const Vec2 x = place(v, torus.map) + Vec2(0.01, -0.02), step(1e-4, 2e-4);
  const auto at = targets.term(v, x), there = targets.term(v, x + step);
  EXPECT_NEAR(there.value - at.value,
              (at.gradient - Vec2(2, 3)).dot(step) + step.dot((at.hessian - Mat2::Identity()) * step) / 2,
              1e-12);
  EXPECT_NEAR(targets.term(v, x + torus.map.lattice * Vec2(2, -1)).value, at.value, 1e-9);
}

TEST_F(FeatureTargetsOnATorus, LargeDifferencesCountLess) {
  VertexMap<Vec2> other = features;
  for (Vec2& f : other.values()) f += Vec2(4, 0);  // no feature differs by so much
  const FeatureTargets targets(further, other, torus.map, field, locator, options);
  for (VertexId v : torus.mesh.vertices()) {
    const double value = targets.term(v, place(v, torus.map)).value - 1;
    const double ratio2 = 16 / (0.4 * 0.4);
    EXPECT_NEAR(value, 3 * 16 / ((1 + ratio2) * (1 + ratio2)), 1e-6);
  }
}

}  // namespace
}  // namespace foramen
