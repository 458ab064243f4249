#include "foramen/core/ids.hpp"

#include <concepts>
#include <type_traits>
#include <vector>

#include <gtest/gtest.h>

namespace foramen {
namespace {

// Conversions between ids of different kinds, and from numbers to ids, must not compile.
static_assert(!std::is_constructible_v<FaceId, VertexId>);
static_assert(!std::is_convertible_v<int, VertexId>);
static_assert(!std::is_convertible_v<VertexId, int>);
template <class A, class B>
concept comparable = requires(A a, B b) {
  a == b;
};
static_assert(comparable<EdgeId, EdgeId> && !comparable<EdgeId, HalfedgeId>);
template <class Map, class Index>
concept indexed_by = requires(Map map, Index i) {
  map[i];
};
static_assert(indexed_by<FaceMap<double>, FaceId> && !indexed_by<FaceMap<double>, VertexId> &&
              !indexed_by<FaceMap<double>, int>);

TEST(Id, IsInvalidUntilItIsGivenAnIndex) {
  EXPECT_FALSE(VertexId().valid());
  EXPECT_EQ(VertexId(), VertexId(-1));
  EXPECT_TRUE(VertexId(0).valid());
  EXPECT_LT(VertexId(3), VertexId(4));
  EXPECT_NE(VertexId(3), VertexId(4));
}

TEST(IdRange, HasEveryIdOnceInOrder) {
  std::vector<int> seen;
  for (const EdgeId e : IdRange<EdgeId>(4)) seen.push_back(e.index);
  EXPECT_EQ(seen, (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(IdRange<EdgeId>(4).size(), 4);
  for (const EdgeId e : IdRange<EdgeId>(0)) ADD_FAILURE() << e.index;
}

TEST(IdMap, HoldsOneValueAnElement) {
  VertexMap<int> map(3, 7);
  map[VertexId(1)] = 5;
  EXPECT_EQ(map.values(), (std::vector<int>{7, 5, 7}));
  EXPECT_EQ(map.size(), 3);
  EXPECT_FALSE(map.empty());
  int sum = 0;
  for (const VertexId v : map.ids()) sum += map[v];
  EXPECT_EQ(sum, 19);
  EXPECT_EQ(map, VertexMap<int>(std::vector<int>{7, 5, 7}));
  EXPECT_NE(map, VertexMap<int>(3, 7));
  EXPECT_TRUE(VertexMap<int>().empty());
}

TEST(IdMap, OfTruthValuesCanBeWrittenTo) {
  FaceMap<bool> marked(2, false);
  marked[FaceId(1)] = true;
  EXPECT_FALSE(marked[FaceId(0)]);
  EXPECT_TRUE(marked[FaceId(1)]);
}

}  // namespace
}  // namespace foramen
