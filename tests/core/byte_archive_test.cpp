#include "core/byte_archive.hpp"

#include <bit>
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "core/kept_results.hpp"
#include "support/meshes.hpp"

namespace foramen {
namespace {

enum class Colour { red, green };

template <class Value>
Value there_and_back(const Value& value) {
  return from_bytes<Value>(to_bytes(value));
}

TEST(ByteArchive, NumbersComeBackBitForBit) {
  for (double x : {0.0, -0.0, 1.0 / 3, 1e-320, std::numeric_limits<double>::infinity(), std::nan("7")})
    EXPECT_EQ(std::bit_cast<std::uint64_t>(there_and_back(x)), std::bit_cast<std::uint64_t>(x));
  for (std::int64_t i :
       {std::int64_t{0}, std::int64_t{-1}, std::int64_t{63}, std::int64_t{-64}, std::int64_t{64},
        std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max()})
    EXPECT_EQ(there_and_back(i), i);
  EXPECT_EQ(there_and_back(std::numeric_limits<int>::min()), std::numeric_limits<int>::min());
  EXPECT_EQ(there_and_back(true), true);
  EXPECT_EQ(there_and_back(Colour::green), Colour::green);
}

TEST(ByteArchive, SmallIntegersTakeOneByte) {
  EXPECT_EQ(to_bytes(63).size(), 1u);
  EXPECT_EQ(to_bytes(-64).size(), 1u);
  EXPECT_EQ(to_bytes(64).size(), 2u);
}

TEST(ByteArchive, WhatIsMadeOfOthersComesBack) {
  EXPECT_EQ(there_and_back(std::string("a\0b", 3)), std::string("a\0b", 3));
  const std::vector<std::optional<std::vector<Vec3>>> points{std::vector<Vec3>{{1, 2, 3}, {4, 5, 6}},
                                                             std::nullopt, std::vector<Vec3>{}};
  EXPECT_EQ(there_and_back(points), points);
  const std::array<Eigen::Matrix2i, 2> matrices{Eigen::Matrix2i::Identity(), Eigen::Matrix2i::Constant(-3)};
  EXPECT_EQ(there_and_back(matrices), matrices);
  EXPECT_EQ(there_and_back(Eigen::MatrixXd(Eigen::MatrixXd::Random(3, 5))).rows(), 3);
  const Eigen::VectorXd vector = Eigen::VectorXd::LinSpaced(7, 0, 1);
  EXPECT_EQ(there_and_back(vector), vector);
  EXPECT_EQ(there_and_back(Eigen::MatrixXd(Eigen::MatrixXd(0, 4))).cols(), 4);
  const VertexMap<FaceId> map(std::vector<FaceId>{FaceId(4), FaceId()});
  EXPECT_EQ(there_and_back(map), map);
  RigidTransform motion = RigidTransform::Identity();
  motion.rotate(Eigen::AngleAxisd(0.7, Vec3(1, 2, 2) / 3)).pretranslate(Vec3(1, 2, std::numbers::pi));
  EXPECT_EQ(there_and_back(motion).matrix(), motion.matrix());
}

TEST(ByteArchive, AMeshHasTheSameConnectivityAgain) {
  const Mesh mesh = build_mesh(testing::renumbered(testing::bumpy_torus_soup(12, 9, 3), 4));
  const Mesh again = there_and_back(mesh);
  EXPECT_EQ(again.soup().points, mesh.soup().points);
  EXPECT_EQ(again.triangles(), mesh.triangles());
  for (HalfedgeId h : mesh.halfedges()) {
    EXPECT_EQ(again.twin(h), mesh.twin(h));
    EXPECT_EQ(again.edge(h), mesh.edge(h));
  }
  for (VertexId v : mesh.vertices()) EXPECT_EQ(again.outgoing(v), mesh.outgoing(v));
  EXPECT_EQ(there_and_back(Mesh()).vertex_count(), 0);
}

TEST(ByteArchive, BytesThatEndTooEarlyOrTooLateAreOurDefect) {
  const std::string bytes = to_bytes(std::vector<double>{1, 2, 3});
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_THROW(from_bytes<std::vector<double>>(bytes.substr(0, size)), InternalError) << size;
  EXPECT_THROW(from_bytes<std::vector<double>>(bytes + "x"), InternalError);
  EXPECT_THROW(from_bytes<std::string>(to_bytes(std::int64_t{1} << 60)), InternalError) << "a lying count";
  EXPECT_THROW(from_bytes<std::string>(to_bytes(-1)), InternalError);
  EXPECT_THROW(from_bytes<int>(std::string(11, '\xff')), InternalError) << "an endless integer";
}

}  // namespace
}  // namespace foramen
