#pragma once
/// \file
/// How shapes are registered: one shape with the reference (first map, soft neighbours of the paper,
/// optimisation), and all shapes of a cohort with each other (the template, its bending, the targets).

#include <string_view>
#include <utility>

#include "foramen/core/options.hpp"
#include "foramen/match/bending_options.hpp"
#include "foramen/parameterize/torus_map.hpp"

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

/// Where the distortion of a shape's map is measured.
enum class DistortionMeasure {
  on_template,  ///< of the map shape -> template: TemplateMetric
  in_plane,     ///< of the map shape -> flat torus
};
template <>
struct EnumWords<DistortionMeasure> {
  static constexpr std::pair<std::string_view, DistortionMeasure> all[] = {
      {"template", DistortionMeasure::on_template}, {"plane", DistortionMeasure::in_plane}};
};

/// How the template is deformed onto a shape before it gives targets for the shape's vertices.
enum class Bending {
  cohort,  ///< deform_template(). From the first round with a mean on, the prior of a shape's displacement is
           ///< learnt from the other shapes: cohort_priors().
  smooth,  ///< deform_template() with the smooth process as prior, independently for each shape
  rigid,   ///< the template is only aligned rigidly with the shape
};
template <>
struct EnumWords<Bending> {
  static constexpr std::pair<std::string_view, Bending> all[] = {
      {"cohort", Bending::cohort}, {"smooth", Bending::smooth}, {"rigid", Bending::rigid}};
};

struct TemplateOptions {
  int vertices = 8000;
  int grid_points = 30000;
};
template <class Visitor>
void describe(Visitor& visit, MaybeConst<TemplateOptions> auto& o) {
  visit(o.vertices, {.name = "vertices", .range = at_least(16), .meaning = "vertices of the template"});
  visit(o.grid_points, {.name = "grid_points",
                        .range = at_least(16),
                        .meaning = "points of the torus grid on which the shapes are averaged"});
}

struct CohortPriorOptions {
  double noise_mm = 0.25;
  double independent_area_mm2 = 20;
  double least_share = 0.02;
};
template <class Visitor>
void describe(Visitor& visit, MaybeConst<CohortPriorOptions> auto& o) {
  visit(o.noise_mm, {.name = "noise",
                     .unit = "mm",
                     .range = above(0),
                     .meaning = "standard deviation of a corresponding point"});
  visit(o.independent_area_mm2, {.name = "independent_area",
                                 .unit = "mm^2",
                                 .range = above(0),
                                 .meaning = "area of a patch that counts as one independent point"});
  visit(o.least_share,
        {.name = "least_share",
         .range = above(0).up_to(1),
         .meaning = "least share of the smooth process's variance that is left to what no other shape does"});
}

struct SurfaceTargetsOptions {
  double reach_mm = 4;
  double min_normal_cosine = 0;
};
template <class Visitor>
void describe(Visitor& visit, MaybeConst<SurfaceTargetsOptions> auto& o) {
  visit(o.reach_mm,
        {.name = "reach",
         .unit = "mm",
         .range = above(0),
         .meaning =
             "distance from the bent template at which a target's weight falls to zero (Tukey's biweight)"});
  visit(o.min_normal_cosine, {.name = "min_normal_cosine",
                              .range = at_least(-1).below(1),
                              .meaning = "least cosine between the normals of a vertex and of its target"});
}

struct FeatureTargetsOptions {
  double weight_mm2 = 24;
  double robust_difference = 0.5;
  double radius_mm = 2.5;
};
template <class Visitor>
void describe(Visitor& visit, MaybeConst<FeatureTargetsOptions> auto& o) {
  visit(o.weight_mm2, {.name = "weight",
                       .unit = "mm^2",
                       .range = at_least(0),
                       .meaning = "weight of the squared difference of the squashed curvatures"});
  visit(o.radius_mm, {.name = "radius",
                      .unit = "mm",
                      .range = above(0),
                      .meaning = "radius of the neighbourhood whose curvatures are compared"});
  visit(o.robust_difference,
        {.name = "robust_difference",
         .range = above(0),
         .meaning = "difference of the squashed curvatures from which on their weight falls"});
}

struct DescriptionLengthOptions {
  double cut_mm2 = 0.01;  ///< lambda_c
};
template <class Visitor>
void describe(Visitor& visit, MaybeConst<DescriptionLengthOptions> auto& o) {
  visit(o.cut_mm2, {.name = "cut",
                    .unit = "mm^2",
                    .range = above(0),
                    .meaning = "variance per unit of weight below which a mode is noise"});
}

struct RegisterGroupOptions {
  InitialMap initial_map = InitialMap::torus;
  EdgeCost edge_cost = EdgeCost::length_weighted;
  double lambda = 0.5;
  int working_vertices = 10000;
  double relative_tolerance = 1e-4;
  int iteration_limit = 200;
  TemplateOptions mean = {};
  DistortionMeasure distortion = DistortionMeasure::on_template;
  Bending bending = Bending::cohort;
  SmoothDisplacementOptions displacements = {};
  CohortPriorOptions cohort = {};
  DeformTemplateOptions first = {};
  /// The normals of matches count for less than in the first bending, because the surfaces are close.
  DeformTemplateOptions again = {.noise_mm = {1, 0.5, 0.25}, .iterations = 2, .match = {.normal_weight = 4}};
  SurfaceTargetsOptions targets = {};
  FeatureTargetsOptions features = {};
  int metric_updates = 2;
  int round_limit = 4;
  /// Converged if the RMS motion of the mean is below this. With Bending::cohort there are at least two
  /// rounds.
  double still_mm = 0.15;
  int description_rounds = 0;
  DescriptionLengthOptions description = {};
};
template <class Visitor>
void describe(Visitor& visit, MaybeConst<RegisterGroupOptions> auto& o) {
  visit(o.lambda, {.name = "lambda",
                   .unit = "mm^2",
                   .range = above(0),
                   .meaning = "weight of distortion against the squared distance to the targets"});
  visit(o.initial_map, {.name = "initial_map", .meaning = "first map of a shape"});
  visit(o.edge_cost, {.name = "edge_cost", .meaning = "cost of an edge when loops are carried to a shape"});
  visit(o.distortion, {.name = "distortion",
                       .meaning = "where distortion is measured: on the template, or in the flat torus"});
  visit(o.bending,
        {.name = "bending",
         .meaning =
             "how the template is brought onto a shape: bent, with what the other shapes tell or each by "
             "itself, or only aligned"});
  visit(o.round_limit,
        {.name = "rounds",
         .range = at_least(0).up_to(100),
         .meaning = "most rounds with the mean as template; 0: the reference stays the template"});
  visit(o.still_mm, {.name = "still",
                     .unit = "mm",
                     .range = at_least(0),
                     .meaning = "RMS motion of the mean below which the rounds end"});
  visit(o.metric_updates,
        {.name = "metric_updates",
         .range = at_least(1),
         .meaning =
             "optimisations of a map in a round, each with the template's metric where the last one left the "
             "map"});
  visit(o.description_rounds,
        {.name = "description_rounds",
         .range = at_least(0),
         .meaning = "further rounds in which the description length of the cohort draws the maps"});
  visit(o.description, {.name = "description", .nesting = Nesting::prefixed});
  visit(o.mean, {.name = "template", .nesting = Nesting::prefixed});
  visit(o.displacements, {.name = "displacement", .nesting = Nesting::prefixed});
  visit(o.cohort, {.name = "cohort", .nesting = Nesting::prefixed});
  visit(o.first, {.name = "bending_first"});
  visit(o.again, {.name = "bending_again"});
  visit(o.targets, {.name = "targets", .nesting = Nesting::prefixed});
  visit(o.features, {.name = "features", .nesting = Nesting::prefixed});
  visit(o.working_vertices, {.name = "working_vertices",
                             .range = at_least(16),
                             .meaning = "vertices of the simplified meshes that carry the search"});
  visit(o.relative_tolerance, {.name = "relative_tolerance",
                               .range = above(0),
                               .meaning = "relative decrease of the energy at which an optimisation stops"});
  visit(o.iteration_limit,
        {.name = "iteration_limit", .range = at_least(1), .meaning = "most iterations of an optimisation"});
}

}  // namespace foramen
