#include "foramen/repair/handles.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "foramen/core/error.hpp"
#include "repair/disk.hpp"
#include "repair/embedded.hpp"
#include "repair/handle_search.hpp"
#include "repair/patching.hpp"
#include "repair/words.hpp"

namespace foramen {
namespace {

using namespace repair_detail;

// Largest width of the removed band, in rings of triangles around the loop.
constexpr int most_rings = 6;

int genus(const Mesh& mesh) { return (2 - mesh.euler_characteristic()) / 2; }

// Removes the narrowest band along the loop whose closing disks do not intersect the surface; nullopt if
// there is none.
std::optional<EditedMesh> closed_along(const Mesh& mesh, const EdgeLoop& loop) {
  FaceSet band = faces_along(mesh, loop);
  for (int ring = 1; ring <= most_rings; ++ring, band = grown(mesh, band)) {
    const auto open = without_faces(mesh, band);
    if (!open) return std::nullopt;
    const auto holes = borders(open->mesh);
    if (std::any_of(holes.begin(), holes.end(), [](const Border& b) { return b.size() > most_loop_points; }))
      return std::nullopt;
    for (Fairness fairness : {Fairness::thin_plate, Fairness::membrane}) {
      EditedMesh closed{with_disks(open->mesh, fairness), open->origin};
      if (genus(closed.mesh) != genus(mesh) - 1) break;
      if (!new_faces_are_embedded(closed.mesh, open->mesh.face_count())) continue;
      closed.origin.values().resize(closed.mesh.vertex_count());
      return closed;
    }
  }
  return std::nullopt;
}

std::string listed(const std::vector<Handle>& handles) {
  std::string text;
  for (const Handle& h : handles) text += (text.empty() ? "" : "; ") + description(h);
  return text;
}

std::string counted(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

void require_noise(const Mesh& mesh, const RemoveHandlesOptions& options, const RunContext& ctx) {
  const int g = genus(mesh);
  if (g > options.most_handles)
    throw TopologyError(
        "genus " + std::to_string(g) + ": more than " + std::to_string(options.most_handles) +
        " handles are no defects of a vertebra's surface; fill cavities and smooth the segmentation");
  std::vector<Handle> anatomy;
  for (const Handle& h : extra_handles(mesh, ctx).handles)
    if (!is_noise(h, options)) anatomy.push_back(h);
  if (anatomy.empty()) return;
  throw TopologyError(
      "genus " + std::to_string(g) + ": beside the canal there " + (anatomy.size() == 1 ? "is " : "are ") +
          counted(anatomy.size(), "handle") + " too large for noise (" + listed(anatomy) +
          "): foramina transversaria of a cervical vertebra are "
          "anatomy, not defects, and such vertebrae are not supported; if it is noise all the same, raise "
          "the limit of handles (" +
          shown_mm(options.noise_mm) + ", for both lengths) or mend the segmentation",
      {{RemedyKind::handle_limit}});
}

}  // namespace

bool is_noise(const Handle& handle, const RemoveHandlesOptions& options) {
  return std::max(handle.length_mm, handle.across_mm) <= options.noise_mm ||
         (handle.kind == LoopKind::handle && handle.length_mm <= options.thin_bridge_mm);
}

std::string description(const Handle& handle) {
  const std::string what = handle.kind == LoopKind::handle   ? "bridge, "
                           : handle.kind == LoopKind::tunnel ? "tunnel, "
                                                             : "handle, ";
  return what + shown_mm(handle.length_mm) + " round and " + shown_mm(handle.across_mm) + " across, at " +
         shown(handle.position);
}

HandleRemoval remove_handles(const Mesh& mesh, const RemoveHandlesOptions& options, const RunContext& ctx) {
  if (!mesh.is_closed() || mesh.face_count() == 0)
    throw TopologyError("handles are sought on a closed surface, found one with boundary");
  if (genus(mesh) == 0)
    throw TopologyError(
        "genus 0: no hole passes through the surface, so the vertebral canal is closed or the arch is open; "
        "neither is a defect that can be mended without knowing where the canal was: mend the segmentation");
  if (genus(mesh) > 1) require_noise(mesh, options, ctx);

  EditedMesh now = unchanged(mesh);
  HandleRemoval result;
  while (genus(now.mesh) > 1) {
    const FoundHandle next = shortest_handle(now.mesh, ctx);
    if (next.handle.kind == LoopKind::neither || !is_noise(next.handle, options))
      throw InvalidInput("a handle that is no noise came to light: " + description(next.handle) +
                         "; mend the segmentation there");
    auto without = closed_along(now.mesh, next.loop);
    Handle removed = next.handle;
    if (!without && next.handle.across_mm <= options.noise_mm) {
      without = closed_along(now.mesh, next.crossing);
      removed.kind = removed.kind == LoopKind::handle ? LoopKind::tunnel : LoopKind::handle;
      std::swap(removed.length_mm, removed.across_mm);
    }
    if (!without)
      throw InvalidInput("no disk closes it without running into the surface: " + description(next.handle) +
                         "; mend the segmentation there");
    now = {without->mesh, composed(now.origin, without->origin)};
    result.removed.push_back(removed);
  }
  result.canal = find_canal(now.mesh);
  if (is_noise(result.canal, options))
    throw TopologyError("the only hole that passes through the surface is no larger than noise (" +
                        description(result.canal) +
                        "): the vertebral canal is closed or the arch is open; mend the segmentation");
  for (const Handle& h : result.removed)
    if (h.kind == LoopKind::handle && h.across_mm >= result.canal.length_mm)
      throw TopologyError("two holes may be the vertebral canal: one of " + shown_mm(result.canal.length_mm) +
                          " round at " + shown(result.canal.position) + ", and one of " +
                          shown_mm(h.across_mm) + " that a thin bridge at " + shown(h.position) +
                          " closes; mend the segmentation");
  result.mesh = std::move(now.mesh);
  result.origin = std::move(now.origin);
  return result;
}

}  // namespace foramen
