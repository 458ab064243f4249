#include <algorithm>

#include <pybind11/stl.h>

#include "bindings.hpp"
#include "foramen/core/error.hpp"
#include "foramen/repair/repair_mesh.hpp"
#include "foramen/spatial/surface_distance.hpp"
#include "foramen/spatial/triangle_tree.hpp"
#include "foramen/synth/synth_cohort.hpp"
#include "modelfiles/mesh_report_json.hpp"
#include "modelfiles/repair_record.hpp"
#include "options.hpp"
#include "remedy_words.hpp"

namespace foramen::python {
namespace {

py::tuple read(const std::string& path) {
  MeshFile file;
  {
    const py::gil_scoped_release unlocked;
    file = read_mesh(path);
  }
  for (Message& note : file.notes) note = note.about(path);
  warn(file.notes);
  return py::make_tuple(points_array(file.soup.points), triangles_array(file.soup.triangles),
                        file.space ? py::object(py::str(name_of(*file.space))) : py::object(py::none()));
}

void write(const std::string& path, const PointArray& points, const TriangleArray& triangles,
           const std::string& space) {
  const TriangleSoup soup = soup_of(points, triangles);
  const auto ends_with = [&](const std::string& extension) { return path.ends_with(extension); };
  if (!ends_with(".ply") && !ends_with(".vtp"))
    throw InvalidInput(path + ": a mesh is written as .ply or .vtp");
  if (ends_with(".ply"))
    write_ply(path, soup, space_of(space));
  else
    write_vtp(path, soup, space_of(space));
}

std::string inspect(const PointArray& points, const TriangleArray& triangles) {
  return text_of(mesh_report_json(inspect_mesh(soup_of(points, triangles))));
}

py::tuple repair(const PointArray& points, const TriangleArray& triangles, double handle_limit,
                 double hole_limit, int threads, const py::object& progress) {
  const TriangleSoup soup = soup_of(points, triangles);
  RepairOptions options;
  options.handles.noise_mm = handle_limit;
  options.hole_perimeter_mm = hole_limit;
  RepairedMesh repaired;
  run_unlocked(threads, progress, [&](const RunContext& ctx) { repaired = repair_mesh(soup, options, ctx); });
  py::array_t<int> origin(static_cast<py::ssize_t>(repaired.mesh.vertex_count()));
  for (VertexId v : repaired.mesh.vertices()) origin.mutable_at(v.index) = repaired.origin[v].index;
  return py::make_tuple(points_array(repaired.mesh.positions()), triangles_array(repaired.mesh.triangles()),
                        origin, text_of(repair_json(repaired.report)));
}

py::list synth(int shapes, std::uint64_t seed, const py::object& deformation, int modes, double amplitude,
               double correlation, int vertices, int threads, const py::object& progress) {
  SynthOptions options;
  options.shapes = shapes;
  options.seed = seed;
  detail::set_field(options.deformation, deformation, "deformation");
  options.modes = modes;
  options.amplitude_mm = amplitude;
  options.correlation_mm = correlation;
  options.vertices = vertices;
  std::vector<SynthShape> made;
  run_unlocked(threads, progress, [&](const RunContext& ctx) { made = synth_cohort(options, ctx); });
  py::list list;
  for (const SynthShape& shape : made)
    list.append(py::make_tuple(points_array(shape.surface.points), triangles_array(shape.surface.triangles),
                               points_array(shape.truth.points), triangles_array(shape.truth.triangles)));
  return list;
}

py::dict distance(const PointArray& points_a, const TriangleArray& triangles_a, const PointArray& points_b,
                  const TriangleArray& triangles_b, int samples, std::uint64_t seed) {
  TriangleSoup a = soup_of(points_a, triangles_a), b = soup_of(points_b, triangles_b);
  SurfaceDistance found;
  {
    const py::gil_scoped_release unlocked;
    found = surface_distance(TriangleTree(build_mesh(std::move(a))), TriangleTree(build_mesh(std::move(b))),
                             {.samples = samples, .seed = seed});
  }
  py::dict out;
  out["mean"] = found.mean;
  out["p95"] = found.p95;
  out["hausdorff"] = found.hausdorff;
  return out;
}

}  // namespace

void add_meshes(py::module_& module) {
  module.def("read_mesh", &read);
  module.def("write_mesh", &write);
  module.def("inspect", &inspect);
  module.def("repair", &repair);
  module.def("synth", &synth);
  module.def("surface_distance", &distance);
}

}  // namespace foramen::python
