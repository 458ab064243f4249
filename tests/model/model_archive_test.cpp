#include "model/model_archive.hpp"

#include <gtest/gtest.h>

#include "foramen/core/rng.hpp"
#include "support/meshes.hpp"

namespace foramen {
namespace {

TEST(ModelArchive, AModelComesBackWithItsAlignment) {
  const TriangleSoup mean = testing::torus_soup(8, 6);
  const Rng root(3);
  std::vector<std::vector<Vec3>> shapes;
  for (int i = 0; i < 4; ++i) {
    Rng rng = root.fork(static_cast<std::uint64_t>(i));
    shapes.push_back(mean.points);
    for (Vec3& p : shapes.back()) p = 1.5 * p + Vec3(rng.normal(), rng.normal(), rng.normal());
  }
  const AlignedModel made = build_shape_model(shapes, mean.triangles,
                                              {.scale = ScaleMode::remove, .weights = LandmarkWeights::area});
  const std::string bytes = to_bytes(made);
  const auto read = from_bytes<AlignedModel>(bytes);
  EXPECT_EQ(to_bytes(read), bytes);
  EXPECT_EQ(read.model.mean(), made.model.mean());
  EXPECT_EQ(read.model.basis(), made.model.basis());
  EXPECT_EQ(read.model.variance(), made.model.variance());
  EXPECT_EQ(read.model.triangles(), made.model.triangles());
  EXPECT_EQ(read.model.weights(), made.model.weights());
  EXPECT_EQ(read.alignment.aligned, made.alignment.aligned);
  EXPECT_EQ(read.alignment.mean, made.alignment.mean);
  EXPECT_EQ(read.alignment.iterations, made.alignment.iterations);
  EXPECT_EQ(read.alignment.converged, made.alignment.converged);
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const SimilarityTransform &a = read.alignment.transforms.at(i), &b = made.alignment.transforms[i];
    EXPECT_NE(b.scale, 1);
    EXPECT_EQ(a.scale, b.scale);
    EXPECT_EQ(a.rotation, b.rotation);
    EXPECT_EQ(a.translation, b.translation);
  }
  EXPECT_EQ(read.model.scores(flattened(read.alignment.aligned[2]), 2),
            made.model.scores(flattened(made.alignment.aligned[2]), 2));
}

}  // namespace
}  // namespace foramen
