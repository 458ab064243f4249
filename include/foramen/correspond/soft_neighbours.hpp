#pragma once
/// \file
/// The correspondence energy of the paper: it attracts every vertex to the torus positions of its nearest
/// neighbours on the reference.

#include "foramen/core/options.hpp"
#include "foramen/parameterize/optimise_map.hpp"

namespace foramen {

/// The distance by which the nearest neighbours are searched.
enum class NeighbourSearch {
  points,  ///< nearest in space, as in the paper; neighbours may lie on the other side of a thin wall
  oriented_points,  ///< nearest by position and normal (8 mm per unit of normal difference)
};
/// The weights w_jk of the neighbours.
enum class NeighbourWeights {
  /// [becker2011 Eq. 4]: exp(-distance / mm), which is nearly 0 where shapes differ by several millimetres.
  absolute,
  relative,  ///< the same weights divided by their sum, so that every vertex has the same total weight
};

template <>
struct EnumWords<NeighbourSearch> {
  static constexpr std::pair<std::string_view, NeighbourSearch> all[] = {
      {"points", NeighbourSearch::points}, {"oriented_points", NeighbourSearch::oriented_points}};
};
template <>
struct EnumWords<NeighbourWeights> {
  static constexpr std::pair<std::string_view, NeighbourWeights> all[] = {
      {"absolute", NeighbourWeights::absolute}, {"relative", NeighbourWeights::relative}};
};

struct SoftNeighboursOptions {
  int count = 8;
  NeighbourSearch search = NeighbourSearch::oriented_points;
  NeighbourWeights weights = NeighbourWeights::relative;
  double smoothing = 1e-3;
};
template <class Visitor>
void describe(Visitor& visit, MaybeConst<SoftNeighboursOptions> auto& o) {
  visit(o.count,
        {.name = "neighbours", .range = at_least(1), .meaning = "reference vertices that draw a vertex"});
  visit(o.search, {.name = "neighbour_search", .meaning = "what the nearest vertices are nearest by"});
  visit(o.weights,
        {.name = "neighbour_weights", .meaning = "whether the weights of a vertex are divided by their sum"});
  visit(o.smoothing, {.name = "neighbour_smoothing",
                      .range = above(0),
                      .meaning = "eps in sqrt(r^2 + eps^2) for a distance r on the torus of area 1"});
}

/// E_cor,j = sum over the q nearest reference vertices k of w_jk |p_j - p_k| [becker2011 Eq. 4]. The distance
/// r is that to the nearest lattice translate, smoothed as sqrt(r^2 + eps^2). Positions are in the plane of
/// the reference's lattice (area 1). The Hessian is exact, and positive semi-definite because the term is
/// convex.
class SoftNeighbours : public CorrespondenceObjective {
 public:
  SoftNeighbours(const Mesh& aligned_shape, const Mesh& reference, const TorusMap& reference_map,
                 const SoftNeighboursOptions& options = {});
  Term term(VertexId v, const Vec2& plane_position) const override;

 private:
  int count_;
  double squared_smoothing_;
  LatticeReducer reducer_;
  std::vector<Vec2> targets_;    // count_ positions per vertex, in the plane
  std::vector<double> weights_;  // count_ weights per vertex
};

}  // namespace foramen
