#include "workflow/inspect_file.hpp"

#include <utility>

#include <nlohmann/json.hpp>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/repair/handles.hpp"
#include "inputs/unused_points.hpp"
#include "modelfiles/mesh_report_json.hpp"
#include "modelfiles/repair_record.hpp"

namespace foramen {
namespace {

using nlohmann::ordered_json;

std::optional<SurfaceHandles> handles_of(const TriangleSoup& soup, const MeshReport& r,
                                         const RunContext& ctx) {
  if (r.genus.value_or(0) < 2 || *r.genus > RemoveHandlesOptions().most_handles || !is_in_millimetres(r) ||
      r.duplicate_triangles + r.invalid_triangles + r.non_finite_vertices > 0)
    return std::nullopt;
  const Mesh mesh = build_mesh(soup);
  try {
    return find_handles(r.inward ? reversed(mesh) : mesh, ctx);
  } catch (const ConvergenceError&) {
    return std::nullopt;  // the surface intersects itself at a handle
  }
}

// Lengths are in mm if the unit is certain or is another than mm.
std::string size_unit_of(const MeshReport& r, const InputUnit& unit) {
  if (is_in_millimetres(r)) return "mm";
  if (unit.certain) return "mm; the size of no vertebra";
  if (unit.length != LengthUnit::millimetre)
    return "mm; the size of no vertebra: the file is not in " + std::string(name(unit.length));
  if (const auto likely = likely_unit(r.box.diagonal()))
    return "not mm; probably " + std::string(name(*likely));
  return "the size of no vertebra in mm, cm, m or um";
}

ordered_json handles_json(const SurfaceHandles& handles) {
  ordered_json extra = ordered_json::array();
  for (const Handle& h : handles.extra) {
    extra.push_back(handle_json(h));
    extra.back()["noise"] = is_noise(h, {});
  }
  return {{"extra", extra}, {"canal", handle_json(handles.canal)}};
}

}  // namespace

InspectedFile inspect_file(const InspectRequest& request, const RunContext& ctx) {
  InspectedFile result{.file = request.file, .error = std::nullopt};
  try {
    MeshFile read = read_mesh(request.file);
    for (Vec3& p : read.soup.points) p *= millimetres_per(request.unit.length);
    result.report = inspect_mesh(read.soup);
    result.size_unit = size_unit_of(result.report, request.unit);
    result.space = read.space;
    result.notes = std::move(read.notes);
    if (const auto note = drop_unused_points(read.soup)) result.notes.push_back(*note);
    if (request.find_handles) result.handles = handles_of(read.soup, result.report, ctx);
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& e) {
    return {.file = request.file, .error = message_of(e)};
  }
  return result;
}

ordered_json inspection_json(const InspectedFile& inspected) {
  ordered_json out = {{"file", inspected.file.string()}};
  if (inspected.error) {
    out["usable"] = false;
    out["finding"] = inspected.error->text;
    return out;
  }
  out.update(mesh_report_json(inspected.report));
  if (inspected.space) out["space"] = *inspected.space == AnatomicalSpace::lps ? "LPS" : "RAS";
  if (!inspected.notes.empty()) out["notes"] = texts_of(inspected.notes);
  if (inspected.handles) out["handles"] = handles_json(*inspected.handles);
  return out;
}

}  // namespace foramen
