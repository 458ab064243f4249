#include "foramen/model/procrustes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <Eigen/LU>

#include "foramen/core/error.hpp"
#include "foramen/core/rng.hpp"

namespace foramen {
namespace {

std::vector<Vec3> cloud(int count, std::uint64_t seed) {
  Rng rng(seed);
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i)
    points.emplace_back(30 * rng.normal(), 20 * rng.normal(), 10 * rng.normal());
  return points;
}

std::vector<Vec3> jittered(std::vector<Vec3> points, double mm, std::uint64_t seed) {
  Rng rng(seed);
  for (Vec3& p : points) p += mm * Vec3(rng.normal(), rng.normal(), rng.normal());
  return points;
}

SimilarityTransform random_motion(std::uint64_t seed, double scale = 1) {
  Rng rng(seed);
  SimilarityTransform t;
  t.scale = scale;
  t.rotation = Eigen::Quaterniond(rng.normal(), rng.normal(), rng.normal(), rng.normal())
                   .normalized()
                   .toRotationMatrix();
  t.translation = 200 * Vec3(rng.normal(), rng.normal(), rng.normal());
  return t;
}

std::vector<Vec3> moved(const std::vector<Vec3>& points, const SimilarityTransform& t) {
  std::vector<Vec3> out;
  for (const Vec3& p : points) out.push_back(t(p));
  return out;
}

double largest_difference(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  EXPECT_EQ(a.size(), b.size());
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, (a[i] - b[i]).norm());
  return largest;
}

double sum_of_squares(const std::vector<Vec3>& moving, const std::vector<Vec3>& fixed,
                      const SimilarityTransform& t) {
  double sum = 0;
  for (std::size_t i = 0; i < moving.size(); ++i) sum += (t(moving[i]) - fixed[i]).squaredNorm();
  return sum;
}

std::vector<std::vector<Vec3>> cohort(int shapes, std::uint64_t seed) {
  const auto base = cloud(60, seed);
  std::vector<std::vector<Vec3>> out;
  for (int s = 0; s < shapes; ++s)
    out.push_back(moved(jittered(base, 2.0, seed + 10 + static_cast<std::uint64_t>(s)),
                        random_motion(seed + 100 + static_cast<std::uint64_t>(s))));
  return out;
}

TEST(SimilarityTransform, InverseAndMatrixAgree) {
  const SimilarityTransform t = random_motion(3, 1.7);
  for (const Vec3& p : cloud(10, 4)) {
    EXPECT_LT((t.inverse()(t(p)) - p).norm(), 1e-12 * 300);
    EXPECT_LT(((t.matrix() * p.homogeneous()).head<3>() - t(p)).norm(), 1e-12 * 300);
  }
}

TEST(FitSimilarity, RecoversAPlantedMotion) {
  const auto points = cloud(20, 1);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const SimilarityTransform truth = random_motion(seed);
    const SimilarityTransform fit = fit_similarity(points, moved(points, truth), ScaleMode::keep);
    EXPECT_LT((fit.rotation - truth.rotation).norm(), 1e-13);
    EXPECT_LT((fit.translation - truth.translation).norm(), 1e-11);
    EXPECT_EQ(fit.scale, 1.0);
    const SimilarityTransform larger = random_motion(seed, 1.3);
    const SimilarityTransform scaled = fit_similarity(points, moved(points, larger), ScaleMode::remove);
    EXPECT_NEAR(scaled.scale, 1.3, 1e-13);
    EXPECT_LT((scaled.matrix() - larger.matrix()).norm(), 1e-11);
  }
}

TEST(FitSimilarity, IsTheLeastSquaresMotion) {
  const auto a = cloud(15, 2), b = jittered(moved(a, random_motion(9)), 4, 3);
  const SimilarityTransform best = fit_similarity(a, b, ScaleMode::remove);
  const double least = sum_of_squares(a, b, best);
  Rng rng(5);
  for (int i = 0; i < 200; ++i) {
    SimilarityTransform other = best;
    other.rotation =
        Eigen::AngleAxisd(0.02 * rng.normal(), Vec3(rng.normal(), rng.normal(), rng.normal()).normalized()) *
        other.rotation;
    other.translation += 0.1 * Vec3(rng.normal(), rng.normal(), rng.normal());
    other.scale *= 1 + 0.01 * rng.normal();
    EXPECT_GT(sum_of_squares(a, b, other), least);
  }
}

TEST(FitSimilarity, NeverChoosesAReflection) {
  const auto points = cloud(30, 7);
  std::vector<Vec3> mirrored = points, flat = points;
  for (Vec3& p : mirrored) p.x() = -p.x();
  for (Vec3& p : flat) p.z() = 0;  // in a plane, a reflection would fit equally well
  for (const auto& fixed : {mirrored, flat}) {
    const SimilarityTransform fit = fit_similarity(points, fixed, ScaleMode::keep);
    EXPECT_NEAR(fit.rotation.determinant(), 1.0, 1e-12);
    EXPECT_LT((fit.rotation * fit.rotation.transpose() - Mat3::Identity()).norm(), 1e-12);
  }
}

TEST(FitSimilarity, LandmarksOfWeightZeroDoNotCount) {
  auto points = cloud(12, 8);
  const SimilarityTransform truth = random_motion(8);
  auto fixed = moved(points, truth);
  fixed[5] += Vec3(50, 0, 0);
  std::vector<double> weights(points.size(), 2.0);
  weights[5] = 0;
  EXPECT_LT((fit_similarity(points, fixed, ScaleMode::keep, weights).matrix() - truth.matrix()).norm(),
            1e-11);
  EXPECT_GT((fit_similarity(points, fixed, ScaleMode::keep).matrix() - truth.matrix()).norm(), 1e-2);
}

TEST(FitSimilarity, RefusesWhatCannotBeFitted) {
  const auto points = cloud(5, 1);
  const std::vector<Vec3> same(5, Vec3(1, 2, 3));
  const auto fewer = cloud(4, 1);
  const std::vector<double> negative{1, 1, -1, 1, 1}, zeros(5, 0.0), short_weights(4, 1.0);
  EXPECT_THROW(fit_similarity(points, fewer, ScaleMode::keep), InvalidInput);
  EXPECT_THROW(fit_similarity({}, {}, ScaleMode::keep), InvalidInput);
  EXPECT_THROW(fit_similarity(same, points, ScaleMode::remove), InvalidInput);
  EXPECT_THROW(fit_similarity(points, points, ScaleMode::keep, negative), InvalidInput);
  EXPECT_THROW(fit_similarity(points, points, ScaleMode::keep, zeros), InvalidInput);
  EXPECT_THROW(fit_similarity(points, points, ScaleMode::keep, short_weights), InvalidInput);
}

TEST(Procrustes, MovesCopiesOfOneShapeOntoEachOther) {
  const auto base = cloud(40, 11);
  std::vector<std::vector<Vec3>> shapes;
  for (std::uint64_t s = 0; s < 6; ++s) shapes.push_back(moved(base, random_motion(s)));
  const ProcrustesResult r = procrustes(shapes, ScaleMode::keep);
  EXPECT_TRUE(r.converged);
  for (const auto& a : r.aligned) EXPECT_LT(largest_difference(a, r.aligned[0]), 1e-11);
  EXPECT_LT(largest_difference(r.mean, r.aligned[0]), 1e-11);
}

TEST(Procrustes, PutsTheMeanAtTheOriginAndKeepsTheFirstShapesOrientation) {
  const auto shapes = cohort(7, 20);
  const ProcrustesResult r = procrustes(shapes, ScaleMode::keep);
  ASSERT_TRUE(r.converged);
  EXPECT_EQ(r.transforms[0].rotation, Mat3(Mat3::Identity()));
  Vec3 centre = Vec3::Zero();
  std::vector<Vec3> average(r.mean.size(), Vec3::Zero());
  for (const auto& a : r.aligned)
    for (std::size_t i = 0; i < a.size(); ++i) average[i] += a[i] / 7;
  for (const Vec3& p : r.mean) centre += p / static_cast<double>(r.mean.size());
  EXPECT_LT(centre.norm(), 1e-11);
  EXPECT_LT(largest_difference(average, r.mean), 1e-11);
  for (std::size_t s = 0; s < shapes.size(); ++s) {
    EXPECT_EQ(r.transforms[s].scale, 1.0);
    EXPECT_LT((r.transforms[s].rotation.transpose() * r.transforms[s].rotation - Mat3::Identity()).norm(),
              1e-14);
    EXPECT_EQ(largest_difference(r.aligned[s], moved(shapes[s], r.transforms[s])), 0.0);
  }
}

TEST(Procrustes, EveryShapeLiesBestOnTheMean) {
  const auto shapes = cohort(6, 30);
  for (const ScaleMode scale : {ScaleMode::keep, ScaleMode::remove}) {
    const ProcrustesResult r = procrustes(shapes, scale);
    ASSERT_TRUE(r.converged);
    for (const auto& a : r.aligned) {
      const SimilarityTransform further = fit_similarity(a, r.mean, ScaleMode::keep);
      EXPECT_LT((further.matrix() - Eigen::Matrix4d::Identity()).norm(), 1e-8);
    }
  }
}

TEST(Procrustes, RigidMotionOfAnyShapeButTheFirstChangesNothing) {
  auto shapes = cohort(5, 40);
  const ProcrustesResult before = procrustes(shapes, ScaleMode::keep);
  for (std::size_t s = 1; s < shapes.size(); ++s) shapes[s] = moved(shapes[s], random_motion(500 + s));
  const ProcrustesResult after = procrustes(shapes, ScaleMode::keep);
  EXPECT_LT(largest_difference(before.mean, after.mean), 1e-7);
  const SimilarityTransform turn = random_motion(77);
  for (auto& shape : shapes) shape = moved(shape, turn);
  const ProcrustesResult turned = procrustes(shapes, ScaleMode::keep);
  for (std::size_t i = 0; i < before.mean.size(); ++i)
    EXPECT_LT((turn.rotation * before.mean[i] - turned.mean[i]).norm(), 1e-7);
}

TEST(Procrustes, RemovesScaleToTheAverageSize) {
  const auto base = cloud(30, 50);
  std::vector<std::vector<Vec3>> shapes;
  for (int s = 0; s < 3; ++s)
    shapes.push_back(moved(base, random_motion(static_cast<std::uint64_t>(s), 0.8 + 0.2 * s)));
  const ProcrustesResult kept = procrustes(shapes, ScaleMode::keep);
  const ProcrustesResult removed = procrustes(shapes, ScaleMode::remove);
  EXPECT_GT(largest_difference(kept.aligned[0], kept.aligned[2]), 1);
  EXPECT_LT(largest_difference(removed.aligned[0], removed.aligned[2]), 1e-11);
  EXPECT_NEAR(removed.transforms[0].scale, 1.25, 1e-12);  // the average size is that of the middle shape
  EXPECT_NEAR(removed.transforms[1].scale, 1.0, 1e-12);
  EXPECT_NEAR(removed.transforms[2].scale, 1 / 1.2, 1e-12);
}

TEST(Procrustes, AShapeOfTheCohortIsAlignedToTheMeanAsItWasBefore) {
  const auto shapes = cohort(6, 60);
  for (const ScaleMode scale : {ScaleMode::keep, ScaleMode::remove}) {
    const ProcrustesResult r = procrustes(shapes, scale);
    for (std::size_t s = 0; s < shapes.size(); ++s)
      EXPECT_LT((align_to_mean(shapes[s], r, scale).matrix() - r.transforms[s].matrix()).norm(), 1e-6);
  }
}

TEST(Procrustes, IsTheSameTwice) {
  const auto shapes = cohort(5, 70);
  EXPECT_EQ(procrustes(shapes, ScaleMode::remove).aligned, procrustes(shapes, ScaleMode::remove).aligned);
}

TEST(Procrustes, RefusesWhatDoesNotCorrespond) {
  auto shapes = cohort(3, 80);
  EXPECT_THROW(procrustes({}, ScaleMode::keep), InvalidInput);
  auto missing = shapes;
  missing[2].pop_back();
  EXPECT_THROW(procrustes(missing, ScaleMode::keep), InvalidInput);
  auto point = shapes;
  point[1].assign(point[1].size(), Vec3(1, 1, 1));
  EXPECT_THROW(procrustes(point, ScaleMode::keep), InvalidInput);
  auto broken = shapes;
  broken[1][3].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(procrustes(broken, ScaleMode::keep), InvalidInput);
}

}  // namespace
}  // namespace foramen
