#include "modelfiles/mesh_report_json.hpp"

#include <nlohmann/json.hpp>

#include "foramen/core/geometry.hpp"
#include "foramen/core/units.hpp"

namespace foramen {

using nlohmann::ordered_json;

bool is_in_millimetres(const MeshReport& report) {
  return report.box.diagonal() >= smallest_diagonal_mm && report.box.diagonal() <= largest_diagonal_mm;
}

ordered_json mesh_report_json(const MeshReport& r) {
  const auto obstacle = obstacle_to_model(r);
  ordered_json out = {
      {"usable", !obstacle},
      {"vertices", r.vertices},
      {"triangles", r.triangles},
      {"edges", r.edges},
      {"closed", r.closed()},
      {"boundary_edges", r.boundary_edges},
      {"manifold", r.manifold()},
      {"non_manifold_edges", r.non_manifold_edges},
      {"non_manifold_vertices", r.non_manifold_vertices},
      {"oriented", r.oriented()},
      {"inward", r.inward},
      {"components", r.components},
      {"euler_number", r.euler_number},
      {"genus", r.genus ? ordered_json(*r.genus) : ordered_json()},
      {"degenerate_triangles", r.degenerate_triangles},
      {"duplicate_triangles", r.duplicate_triangles},
      {"duplicate_vertices", r.duplicate_vertices},
      {"invalid_triangles", r.invalid_triangles},
      {"non_finite_vertices", r.non_finite_vertices},
      {"unused_vertices", r.unused_vertices},
      {"bounding_box",
       {{r.box.low.x(), r.box.low.y(), r.box.low.z()}, {r.box.high.x(), r.box.high.y(), r.box.high.z()}}},
      {"diagonal", r.box.diagonal()},
      {"area", r.area},
      {"volume", r.volume},
      {"mean_edge", r.mean_edge}};
  const auto likely = likely_unit(r.box.diagonal());
  out["likely_units"] = is_in_millimetres(r) ? ordered_json("mm")
                        : likely             ? ordered_json(name(*likely))
                                             : ordered_json();
  if (obstacle) {
    out["finding"] = obstacle->finding;
    out["remedy"] = obstacle->advice;
  }
  return out;
}

}  // namespace foramen
