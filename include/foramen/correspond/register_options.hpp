#pragma once
/// \file
/// How one shape is registered with the reference: first map, the paper's soft neighbours, optimisation.

#include <string_view>
#include <utility>

#include "foramen/core/options.hpp"
#include "foramen/parameterize/optimiser.hpp"

namespace foramen {

/// The kind of the first map of a shape.
enum class InitialMap {
  torus,  ///< harmonic map (harmonic_torus_map())
  /// The initial map of the paper: the surface is cut along the loops and its border fixed to a rectangle
  /// (rectangle_torus_map()).
  rectangle,
};
template <>
struct EnumWords<InitialMap> {
  static constexpr std::pair<std::string_view, InitialMap> all[] = {{"torus", InitialMap::torus},
                                                                    {"rectangle", InitialMap::rectangle}};
};

/// The cost of an edge in the search for loops that follow those of the reference.
enum class EdgeCost {
  /// [becker2011 Eq. 3] as printed: mean distance of the two ends to the reference loops [mm]; the cost of a
  /// path depends on its number of edges.
  paper,
  /// (paper's cost + 0.5 mm) * edge length [mm^2]; the cost of a path does not depend on the resolution of
  /// the mesh.
  length_weighted,
};
template <>
struct EnumWords<EdgeCost> {
  static constexpr std::pair<std::string_view, EdgeCost> all[] = {
      {"paper", EdgeCost::paper}, {"length_weighted", EdgeCost::length_weighted}};
};

/// The distance by which the nearest neighbours are searched.
enum class NeighbourSearch {
  points,  ///< nearest in space, as in the paper; neighbours may lie on the other side of a thin wall
  oriented_points,  ///< nearest by position and normal (8 mm per unit of normal difference)
};
template <>
struct EnumWords<NeighbourSearch> {
  static constexpr std::pair<std::string_view, NeighbourSearch> all[] = {
      {"points", NeighbourSearch::points}, {"oriented_points", NeighbourSearch::oriented_points}};
};

/// The weights w_jk of the neighbours.
enum class NeighbourWeights {
  /// [becker2011 Eq. 4]: exp(-distance / mm), which is nearly 0 where shapes differ by several millimetres.
  absolute,
  relative,  ///< the same weights divided by their sum, so that every vertex has the same total weight
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

struct RegisterOptions {
  InitialMap initial_map = InitialMap::torus;
  Optimiser optimiser = Optimiser::newton;
  Weighting weighting = Weighting::area;
  EdgeCost edge_cost = EdgeCost::length_weighted;
  SoftNeighboursOptions neighbours = {};
  double lambda = 0.05;
  int working_vertices = 10000;
  double relative_tolerance = 1e-4;
  int iteration_limit = 200;
};
template <class Visitor>
void describe(Visitor& visit, MaybeConst<RegisterOptions> auto& o) {
  visit(o.lambda,
        {.name = "lambda", .range = above(0), .meaning = "weight of distortion against correspondence"});
  visit(o.weighting,
        {.name = "weighting", .meaning = "whether terms are weighted by their area or counted each"});
  visit(o.initial_map, {.name = "initial_map", .meaning = "first map of a shape"});
  visit(o.optimiser, {.name = "optimiser", .meaning = "projected Newton, or the paper's node-wise descent"});
  visit(o.edge_cost, {.name = "edge_cost", .meaning = "cost of an edge when loops are carried to a shape"});
  visit(o.neighbours, {.nesting = Nesting::inlined});
  visit(o.working_vertices, {.name = "working_vertices",
                             .range = at_least(16),
                             .meaning = "vertices of the simplified mesh that carries the search"});
  visit(o.relative_tolerance, {.name = "relative_tolerance",
                               .range = above(0),
                               .meaning = "relative decrease of the energy at which an optimisation stops"});
  visit(o.iteration_limit,
        {.name = "iteration_limit", .range = at_least(1), .meaning = "most iterations of an optimisation"});
}

/// The choices of the paper: eq. 3 as printed, rectangle, node-wise Polak-Ribiere, eq. 4 with nearest points
/// in space, lambda = 0.00025.
RegisterOptions paper_options();

}  // namespace foramen
