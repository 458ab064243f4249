#include "foramen/extract/extract_label.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/core/rng.hpp"
#include "foramen/topology/inspect_mesh.hpp"
#include "spatial/self_intersections.hpp"
#include "support/label_maps.hpp"
#include "support/messages.hpp"
#include "support/real_data.hpp"

namespace foramen {
namespace {

using namespace testing;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr int label = 20;

ExtractedSurface extract(const LabelMap& map, const ExtractOptions& options = {}) {
  return extract_label(map, label, find_labels(map).at(label), options);
}

Mat3 oblique() { return Eigen::AngleAxisd(0.35, Vec3(1, 2, 0.5).normalized()).toRotationMatrix(); }

LabelMap torus_map(const Vec3& spacing, const Mat3& direction = oblique()) {
  const Vec3 half(26, 26, 26);
  std::array<int, 3> size{};
  for (std::size_t a = 0; a < 3; ++a)
    size[a] = static_cast<int>(2 * half[static_cast<int>(a)] / spacing[static_cast<int>(a)]);
  return labelled_lattice(size, direction * spacing.asDiagonal(),
                          [](const Vec3& p) { return bumpy_torus(p) < 0 ? label : 0; });
}

// The same voxels at the same places, stored in another order: axis a of the new map runs along axis order[a]
// of the old one, in the opposite direction if backwards[a].
LabelMap restored(const LabelMap& map, const std::array<int, 3>& order,
                  const std::array<bool, 3>& backwards) {
  LabelMap out;
  out.origin = map.origin;
  std::array<int, 3> start{}, step{};
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t s = order[a];
    out.size[a] = map.size[s];
    start[a] = backwards[a] ? map.size[s] - 1 : 0;
    step[a] = backwards[a] ? -1 : 1;
    out.origin += start[a] * map.axes.col(order[a]);
    out.axes.col(static_cast<int>(a)) = step[a] * map.axes.col(order[a]);
  }
  for (int k = 0; k < out.size[2]; ++k)
    for (int j = 0; j < out.size[1]; ++j)
      for (int i = 0; i < out.size[0]; ++i) {
        std::array<int, 3> at{};
        const std::array<int, 3> here{i, j, k};
        for (std::size_t a = 0; a < 3; ++a) at[order[a]] = start[a] + step[a] * here[a];
        out.labels.push_back(map.at(at[0], at[1], at[2]));
      }
  return out;
}

double rms_distance_to_truth(const TriangleSoup& surface) {
  double sum = 0;
  for (const Vec3& p : surface.points) sum += std::pow(bumpy_torus(p), 2);
  return std::sqrt(sum / static_cast<double>(surface.points.size()));
}

TEST(ExtractLabel, IsCloseToTheVoxelsAndCloserToTheTruth) {
  for (const Vec3& spacing : {Vec3(1, 1, 2), Vec3(0.8, 0.8, 0.8), Vec3(0.8, 3, 0.8)}) {
    SCOPED_TRACE(spacing.transpose());
    const LabelMap map = torus_map(spacing);
    const ExtractedSurface found = extract(map);
    const MeshReport report = inspect_mesh(found.surface);
    EXPECT_EQ(report.genus, 1);
    EXPECT_EQ(found.report.genus, 1);
    EXPECT_FALSE(report.inward);
    EXPECT_TRUE(self_intersections(TriangleTree(build_mesh(found.surface))).empty());
    EXPECT_NEAR(found.report.voxel_volume, static_cast<double>(found.report.voxels) * spacing.prod(), 1e-6);
    EXPECT_NEAR(report.volume, found.report.volume, 1e-6 * report.volume);
    EXPECT_LT(std::abs(found.report.volume / found.report.voxel_volume - 1), 1e-3);
    EXPECT_LE(found.report.deviation.p95, 0.5);
    EXPECT_LE(found.report.deviation_mm.p95, 0.5 * spacing.maxCoeff());
    const ExtractedSurface stepped = extract(map, {.smoothing_rounds = 0});
    EXPECT_LT(rms_distance_to_truth(found.surface), 0.8 * rms_distance_to_truth(stepped.surface));
  }
}

TEST(ExtractLabel, NoVertexLeavesItsBall) {
  const LabelMap map = torus_map({1, 1, 2}, Mat3::Identity());
  const TriangleSoup start = extract(map, {.smoothing_rounds = 0}).surface;
  for (const double bound : {0.5, 0.2}) {
    const ExtractedSurface smoothed = extract(map, {.smoothing_rounds = 60, .bound_voxels = bound});
    const TriangleSoup& end = smoothed.surface;
    double farthest = 0;
    for (std::size_t v = 0; v < end.points.size(); ++v)
      farthest = std::max(farthest, (end.points[v] - start.points[v]).cwiseQuotient(Vec3(1, 1, 2)).norm());
    EXPECT_LE(farthest, smoothed.report.bound + 1e-12);
    EXPECT_GT(farthest, 0.9 * smoothed.report.bound) << "so many rounds reach it";
  }
}

TEST(ExtractLabel, TheSamePointsHoweverTheMapIsStored) {
  const LabelMap map = torus_map({2, 3, 2.5});
  const TriangleSoup expected = extract(map).surface;
  std::array<int, 3> order{0, 1, 2};
  do {
    for (const unsigned flips : {7U, 2U + static_cast<unsigned>(order[0]) % 2U}) {
      const TriangleSoup found =
          extract(restored(map, order, {(flips & 1U) != 0, (flips & 2U) != 0, (flips & 4U) != 0})).surface;
      ASSERT_EQ(found.triangles, expected.triangles);
      double largest = 0;
      for (std::size_t v = 0; v < found.points.size(); ++v)
        largest = std::max(largest, (found.points[v] - expected.points[v]).norm());
      EXPECT_LT(largest, 1e-6);
    }
  } while (std::next_permutation(order.begin(), order.end()));
}

// For any direction matrix, including reflections, the bump must have its place in space.
TEST(ExtractLabel, HasItsPlaceInSpaceAndIsWoundOutward) {
  Rng rng(5);
  for (int repeat = 0; repeat < 8; ++repeat) {
    Mat3 direction = Eigen::Quaterniond(rng.normal(), rng.normal(), rng.normal(), rng.normal())
                         .normalized()
                         .toRotationMatrix();
    if (repeat % 2 == 1) direction.col(rng.below(3)) *= -1;
    const ExtractedSurface found = extract(torus_map({1.5, 1.5, 2}, direction));
    EXPECT_EQ(inspect_mesh(found.surface).genus, 1);
    EXPECT_GT(signed_volume(build_mesh(found.surface)), 0);
    double farthest = 0;
    for (const Vec3& p : found.surface.points) farthest = std::max(farthest, std::abs(bumpy_torus(p)));
    EXPECT_LT(farthest, Vec3(1.5, 1.5, 2).norm() / 2 + 0.5);
  }
}

TEST(ExtractLabel, ACutVertebraIsRefusedWithItsSideUnlessAsked) {
  LabelMap map = torus_map({1, 1, 2}, Vec3(-1, 1, 1).asDiagonal());
  const int cut = map.size[2] / 2;
  map.size[2] = cut;
  map.labels.resize(map.size[0] * map.size[1] * cut);
  try {
    extract(map);
    ADD_FAILURE() << "not refused";
  } catch (const InvalidInput& e) {
    EXPECT_THAT(e.what(), HasSubstr("border of the label map (superior)"));
    EXPECT_THAT(message_of(e), offers({{RemedyKind::keep_cut}}));
  }
  const ExtractedSurface kept = extract(map, {.keep_cut = true});
  EXPECT_THAT(kept.report.cut_at, ElementsAre("superior"));
  EXPECT_TRUE(inspect_mesh(kept.surface).closed());
}

TEST(ExtractLabel, ASpeckAtTheBorderIsNoCut) {
  LabelMap map = torus_map({1, 1, 2});
  map.labels.front() = label;
  const ExtractedSurface found = extract(map);
  EXPECT_EQ(found.report.components, 2);
  EXPECT_EQ(found.report.lost_voxels, 1);
  EXPECT_TRUE(found.report.cut_at.empty());
}

// A label map with one drawn layer, in which '#' is the label.
LabelMap drawn(const std::vector<std::string>& rows) {
  LabelMap map;
  map.size = {static_cast<int>(rows[0].size()), static_cast<int>(rows.size()), 5};
  for (int k = 0; k < 5; ++k)
    for (const std::string& row : rows)
      for (const char c : row) map.labels.push_back(k >= 1 && k <= 3 && c == '#' ? label : 0);
  return map;
}

TEST(ExtractLabel, EdgeContactsAreReadSoThatTheGenusIsOne) {
  // A ring that is closed only by a contact along an edge.
  const ExtractedSurface ring = extract(drawn({"       ",  //
                                               "  ###  ",  //
                                               " #   # ",  //
                                               " #   # ",  //
                                               "  ###  ",  //
                                               "       "}));
  EXPECT_EQ(ring.report.genus, 1);
  EXPECT_EQ(ring.report.contact, EdgeContact::joined);
  // A ring with two tongues that touch only along an edge.
  const ExtractedSurface tongues = extract(drawn({"         ",  //
                                                  " ####### ",  //
                                                  " #   # # ",  //
                                                  " #   # # ",  //
                                                  " #  #  # ",  //
                                                  " #  #  # ",  //
                                                  " ####### ",  //
                                                  "         "}));
  EXPECT_EQ(tongues.report.genus, 1);
  EXPECT_EQ(tongues.report.contact, EdgeContact::apart);
}

TEST(ExtractLabel, ARaggedLabelStillHasASurfaceThatDoesNotMeetItself) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    Rng rng(seed);
    const LabelMap map = labelled_lattice({14, 13, 12}, Vec3(1, 1, 2).asDiagonal(), [&](const Vec3& p) {
      return p.cwiseAbs().maxCoeff() < 9 && rng.uniform(0, 1) < 0.2 + 0.15 * static_cast<double>(seed) ? label
                                                                                                       : 0;
    });
    const ExtractedSurface found = extract(map, {.keep_cut = true});
    EXPECT_TRUE(self_intersections(TriangleTree(build_mesh(found.surface))).empty());
    EXPECT_EQ(inspect_mesh(found.surface).genus, found.report.genus);
  }
}

// Label maps are often enlarged by copying voxels. The resulting blocks are too large to be smoothed by
// moving vertices half a voxel.
TEST(ExtractLabel, BlocksLowerTheBoundAndStayWithinHalfAVoxel) {
  const LabelMap small = torus_map({2.4, 2.4, 2.4});
  LabelMap blocks;
  blocks.axes = small.axes / 3;
  blocks.origin = small.origin - blocks.axes * Vec3::Ones();
  for (std::size_t a = 0; a < 3; ++a) blocks.size[a] = 3 * small.size[a];
  for (int k = 0; k < blocks.size[2]; ++k)
    for (int j = 0; j < blocks.size[1]; ++j)
      for (int i = 0; i < blocks.size[0]; ++i) blocks.labels.push_back(small.at(i / 3, j / 3, k / 3));
  const ExtractedSurface found = extract(blocks);
  EXPECT_LT(found.report.bound, 0.5);
  EXPECT_LE(found.report.deviation.p95, 0.5);
  EXPECT_EQ(found.report.genus, 1);
}

TEST(ExtractLabel, OptionsOutOfRangeAreRefused) {
  const LabelMap map = drawn({"   ", " # ", "   "});
  EXPECT_THROW(extract(map, {.smoothing_rounds = -1}), InvalidInput);
  EXPECT_THROW(extract(map, {.bound_voxels = 0.6}), InvalidInput);
  EXPECT_THROW(extract(map, {.bound_voxels = 0}), InvalidInput);
}

TEST(FindLabels, CountsAndBoxes) {
  LabelMap map;
  map.size = {3, 2, 2};
  map.labels = {0, 7, 7, 0, 0, 7, 2, 0, 0, 0, 0, 2};
  const auto found = find_labels(map);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found.at(7).voxels, 3);
  EXPECT_THAT(found.at(7).low, ElementsAre(1, 0, 0));
  EXPECT_THAT(found.at(7).high, ElementsAre(2, 1, 0));
  EXPECT_THAT(found.at(2).low, ElementsAre(0, 0, 1));
  EXPECT_THAT(found.at(2).high, ElementsAre(2, 1, 1));
}

TEST(ExtractLabelRealData, VerseVertebraeAreWithinHalfAVoxelAndOnePercent) {
  FORAMEN_NEEDS_REAL_DATA();
  const LabelMap map = read_label_map(data_dir() / "labels" / "verse004.nii.gz");
  const auto labels = find_labels(map);
  EXPECT_EQ(labels.size(), 9u);
  for (const auto& [which, extent] : labels) {
    SCOPED_TRACE(which);
    const ExtractedSurface found = extract_label(map, which, extent);
    const MeshReport report = inspect_mesh(found.surface);
    EXPECT_TRUE(report.closed() && report.manifold() && report.oriented() && report.components == 1);
    EXPECT_EQ(report.genus, which == 24 ? 2 : 1) << "L5 has a handle too many";
    EXPECT_FALSE(report.inward);
    EXPECT_LE(found.report.deviation.p95, 0.5);
    EXPECT_LT(std::abs(report.volume / found.report.voxel_volume - 1), 0.01);
  }
}

}  // namespace
}  // namespace foramen
