#include "workflow/repair_file.hpp"

#include <functional>
#include <utility>

#include <nlohmann/json.hpp>

#include "foramen/core/error.hpp"
#include "foramen/io/mesh_file.hpp"
#include "inputs/read_cohort.hpp"
#include "io/file_bytes.hpp"
#include "modelfiles/repair_record.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

using SurfaceWriter = std::function<void(const fs::path&, const TriangleSoup&, AnatomicalSpace)>;

SurfaceWriter writer_for(const fs::path& output) {
  const std::string extension = io_detail::lower_case(output.extension().string());
  if (extension == ".ply")
    return [](const auto& path, const auto& soup, auto space) { write_ply(path, soup, space); };
  if (extension == ".vtp") return write_vtp;
  throw InvalidInput(output.string() + ": a repaired surface is written as .ply or .vtp; give such a name",
                     {{RemedyKind::another_output}});
}

// A file name may contain bytes that are invalid in UTF-8, but JSON must be valid UTF-8.
std::string json_of(const RepairRequest& request, const RepairedMesh& repaired) {
  ordered_json out = {{"input", request.input.string()}, {"output", request.output.string()}};
  out.update(repair_json(repaired.report));
  out["vertices"] = repaired.mesh.vertex_count();
  out["triangles"] = repaired.mesh.face_count();
  ordered_json origin = ordered_json::array();
  for (VertexId raw : repaired.origin) origin.push_back(raw.index);
  out["origin"] = std::move(origin);
  return out.dump(2, ' ', false, ordered_json::error_handler_t::replace);
}

std::vector<std::string> lines_of(const RepairRequest& request, const RepairedMesh& repaired) {
  const RepairReport& report = repaired.report;
  std::vector<std::string> lines{request.input.string() + ": " + summary(report),
                                 "the canal: " + description(report.canal)};
  if (report.largest_move_mm > 0)
    lines.push_back("no vertex that was kept moved by more than " + std::to_string(report.largest_move_mm) +
                    " mm");
  lines.push_back("wrote " + request.output.string() + ": " + std::to_string(repaired.mesh.vertex_count()) +
                  " vertices, " + std::to_string(repaired.mesh.face_count()) + " triangles, genus 1");
  return lines;
}

}  // namespace

RepairSummary repair_file(const RepairRequest& request, const RunContext& ctx) {
  const SurfaceWriter write = writer_for(request.output);
  const std::string name = request.input.string();
  RepairSummary result;
  MeshFile file = read_mesh(request.input);
  for (const Message& note : file.notes) result.notes.push_back(note.about(name));
  RepairedMesh repaired;
  try {
    repaired = repair_surface(std::move(file.soup), request.unit, request.options, ctx);
  } catch (const InvalidInput& e) {
    result.refusal = message_of(e).about(name);
    return result;
  }
  TriangleSoup soup = repaired.mesh.soup();
  for (Vec3& p : soup.points) p /= millimetres_per(request.unit.length);
  write(request.output, soup, file.space.value_or(AnatomicalSpace::lps));

  result.lines = lines_of(request, repaired);
  result.json = json_of(request, repaired);
  if (const auto note = size_note(repaired.mesh, request.unit)) result.notes.push_back(note->about(name));
  if (const auto& meeting = repaired.report.remaining_self_intersections; !meeting.empty())
    result.notes.emplace_back(std::to_string(meeting.size()) +
                              " pairs of triangles meet still; mend the segmentation there");
  return result;
}

}  // namespace foramen
