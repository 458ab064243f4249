#include "synth/isosurface.hpp"

#include <cmath>
#include <string>

#include "foramen/core/error.hpp"
#include "synth/implicit_remesher.hpp"
#include "synth/marching_tetrahedra.hpp"

namespace foramen {
namespace {

constexpr int fewest_vertices = 100;
constexpr double count_tolerance = 0.05;
constexpr double surface_tolerance_mm = 1e-8;
constexpr int polishing_rounds = 3;

void require(bool fine, const std::string& message) {
  if (!fine) throw InvalidInput("isosurface: " + message);
}

// Edge length of equilateral triangles that cover the area with two triangles per vertex (F = 2 V on a torus
// and nearly so on other surfaces).
double edge_length_for(double area, int vertices) {
  return std::sqrt(2 * area / (std::sqrt(3.0) * vertices));
}

}  // namespace

TriangleSoup isosurface(const ImplicitFunction& function, const IsosurfaceOptions& options) {
  require(options.spacing_mm > 0, "spacing_mm must be > 0, found " + std::to_string(options.spacing_mm));
  require(options.vertices >= fewest_vertices, "vertices must be at least " +
                                                   std::to_string(fewest_vertices) + ", found " +
                                                   std::to_string(options.vertices));
  require(options.rounds >= 0, "rounds must be >= 0, found " + std::to_string(options.rounds));
  TriangleSoup first = synth::march_tetrahedra(function, options.bounds, options.spacing_mm, options.lattice);
  require(!first.triangles.empty(),
          "no lattice point within the bounds is inside the surface; use a finer spacing_mm");

  synth::ImplicitRemesher remesher(function, std::move(first), options.spacing_mm);
  if (options.rounds > 0) {
    for (int round = 0; round < options.rounds; ++round)
      remesher.equalise(edge_length_for(remesher.area(), options.vertices));
    remesher.adjust_vertex_count(options.vertices);
    for (int round = 0; round < polishing_rounds; ++round) remesher.polish();
    const double missed = std::abs(remesher.vertex_count() - options.vertices);
    if (missed > count_tolerance * options.vertices)
      throw ConvergenceError("isosurface: " + std::to_string(options.vertices) + " vertices wanted, " +
                             std::to_string(remesher.vertex_count()) +
                             " reached; the surface is too thin for so few, ask for more");
  }
  if (remesher.residual() > surface_tolerance_mm)
    throw ConvergenceError("isosurface: a vertex stays " + std::to_string(remesher.residual()) +
                           " mm off the surface; is the function smooth near its zero set?");
  return remesher.soup();
}

}  // namespace foramen
