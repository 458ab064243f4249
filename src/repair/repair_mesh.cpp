#include "foramen/repair/repair_mesh.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/spatial/triangle_tree.hpp"
#include "foramen/topology/inspect_mesh.hpp"
#include "repair/disk.hpp"
#include "repair/embedded.hpp"
#include "repair/open_non_manifold.hpp"
#include "repair/part_sheets.hpp"
#include "repair/patching.hpp"
#include "repair/pieces.hpp"
#include "repair/words.hpp"
#include "repair/zero_area.hpp"

namespace foramen {
namespace {

using namespace repair_detail;

// Whether most of the points lie inside a closed surface, by the normal of the closest triangle.
bool is_inside(const TriangleTree& surface, const std::vector<Vec3>& points) {
  int inside = 0;
  for (const Vec3& p : points) {
    const ClosestPoint closest = surface.closest(p);
    if ((p - closest.point).dot(area_vector(surface.mesh().triangle(closest.on.face))) < 0) ++inside;
  }
  return 2 * inside > static_cast<int>(points.size());
}

// Whether the soup is one closed, manifold, oriented surface without invalid or duplicate triangles.
bool is_one_surface(const TriangleSoup& soup) {
  const MeshReport report = inspect_mesh(soup);
  return report.genus.has_value() && report.invalid_triangles == 0 && report.duplicate_triangles == 0;
}

class Repair {
 public:
  Repair(const TriangleSoup& raw, const RepairOptions& options, const RunContext& ctx)
      : options_(options), ctx_(ctx), raw_(checked(raw)) {}

  RepairedMesh run() {
    clean_soup();
    wind_and_close();
    judge_dropped_pieces();
    remove_zero_area();
    part();
    cut_handles();
    return result();
  }

 private:
  void note(RepairKind kind, std::vector<Vec3> positions) {
    if (!positions.empty()) report_.changes.push_back({kind, std::move(positions)});
  }

  void clean_soup() {
    note(RepairKind::unused_vertices, drop_unused_vertices(raw_));
    // On a surface without defects, points of equal coordinates belong to parts that touch. Merging them
    // would make it non-manifold.
    if (!is_one_surface(raw_.soup)) {
      note(RepairKind::duplicate_vertices, join_duplicate_vertices(raw_));
      note(RepairKind::zero_area_triangles, drop_triangles_with_repeated_corner(raw_));
      note(RepairKind::duplicate_triangles, drop_duplicate_triangles(raw_));
      require_triangles();
      OpenedPlaces opened = open_non_manifold(raw_);
      note(RepairKind::flaps, std::move(opened.flaps));
      note(RepairKind::non_manifold_edges, std::move(opened.edges));
      note(RepairKind::non_manifold_vertices, std::move(opened.vertices));
      require_triangles();
      dropped_ = keep_largest_piece(raw_);
      drop_unused_vertices(raw_);
    }
  }

  void require_triangles() const {
    if (raw_.soup.triangles.empty())
      throw InvalidInput("none of its triangles is one; export the surface of the bone again");
  }

  void wind_and_close() {
    const std::vector<char> turned = wind_alike(raw_);
    const TriangleSoup& soup = raw_.soup;
    Mesh mesh = build_mesh(soup);
    VertexMap<VertexId> origin(mesh.vertex_count());
    for (VertexId v : mesh.vertices()) origin[v] = VertexId(raw_.origin[v.index]);

    const auto holes = borders(mesh);
    for (const Border& hole : holes) holes_.push_back(border_centre(mesh, hole));
    if (!holes.empty()) mesh = filled(mesh, holes);
    origin.values().resize(mesh.vertex_count());
    const bool inward = signed_volume(mesh) < 0;
    if (inward) mesh = reversed(mesh);
    now_ = {mesh, std::move(origin)};

    std::vector<Vec3> reversed_at;
    for (std::size_t f = 0; f < turned.size(); ++f)
      if ((turned[f] != 0) != inward) reversed_at.push_back(centre(soup, soup.triangles[f]));
    reversed_ = std::move(reversed_at);
  }

  Mesh filled(const Mesh& open, const std::vector<Border>& holes) const {
    for (const Border& hole : holes) {
      const double length = border_length(open, hole);
      if (length > options_.hole_perimeter_mm || hole.size() > most_loop_points)
        throw InvalidInput(
            "it is open: a hole of " + shown_mm(length) + " round (" + std::to_string(hole.size()) +
            " edges) at " + shown(border_centre(open, hole)) + ", and holes of at most " +
            shown_mm(options_.hole_perimeter_mm) + " and " + std::to_string(most_loop_points) +
            " edges are filled; if the bone is cut off at the edge of the scan, this shape cannot be "
            "used, otherwise close the hole in the segmentation or in a mesh editor");
    }
    Mesh closed = with_disks(open, Fairness::thin_plate);
    if (!new_faces_are_embedded(closed, open.face_count())) closed = with_disks(open, Fairness::membrane);
    return closed;
  }

  // Classifies the dropped pieces as inside or outside, which needs a closed surface.
  void judge_dropped_pieces() {
    std::vector<Vec3> stray, inner;
    if (!dropped_.empty()) {
      const TriangleTree surface(now_.mesh);
      const double limit = options_.stray_share * total_area(now_.mesh);
      for (const DroppedPiece& piece : dropped_) {
        const bool inside = is_inside(surface, piece.samples);
        (inside ? inner : stray).push_back(piece.position);
        if (!inside && piece.area > limit)
          throw InvalidInput("it consists of separate pieces of like size: beside the largest, of " +
                             std::to_string(static_cast<long>(total_area(now_.mesh))) +
                             " mm^2, there is one of " + std::to_string(static_cast<long>(piece.area)) +
                             " mm^2 at " + shown(piece.position) +
                             "; keep the vertebra alone, in the segmentation or in a mesh editor");
      }
    }
    note(RepairKind::stray_components, std::move(stray));
    note(RepairKind::inner_shells, std::move(inner));
    note(RepairKind::reversed_triangles, std::move(reversed_));
    note(RepairKind::holes, std::move(holes_));
  }

  void edit(const EditedMesh& next) { now_ = {next.mesh, composed(now_.origin, next.origin)}; }

  void remove_zero_area() {
    WithoutZeroArea without = without_zero_area(now_.mesh);
    if (without.positions.empty()) return;
    edit(without.edited);
    const auto before =
        std::find_if(report_.changes.begin(), report_.changes.end(),
                     [](const RepairChange& c) { return c.kind == RepairKind::zero_area_triangles; });
    if (before == report_.changes.end())
      note(RepairKind::zero_area_triangles, std::move(without.positions));
    else
      before->positions.insert(before->positions.end(), without.positions.begin(), without.positions.end());
  }

  void part() {
    PartedSheets parted = parted_sheets();
    edit({parted.mesh, parted.origin});
    note(RepairKind::self_intersections, std::move(parted.positions));
    report_.remaining_self_intersections = std::move(parted.remaining);
    report_.largest_move_mm = parted.largest_move_mm;
  }

  PartedSheets parted_sheets() const {
    try {
      return part_sheets(now_.mesh);
    } catch (const ConvergenceError& e) {
      throw InvalidInput(std::string(e.what()) + "; export the surface of the bone again");
    }
  }

  HandleRemoval removal_of_handles() const {
    try {
      return remove_handles(now_.mesh, options_.handles, ctx_);
    } catch (const ConvergenceError& e) {
      const auto& meeting = report_.remaining_self_intersections;
      throw InvalidInput(
          "its handles cannot be told apart: " + std::string(e.what()) +
          (meeting.empty() ? std::string() : "; it runs through itself at " + shown(meeting.front())) +
          "; mend the segmentation there");
    }
  }

  void cut_handles() {
    HandleRemoval removal = removal_of_handles();
    edit({removal.mesh, removal.origin});
    for (const auto& [kind, loop] : {std::pair(RepairKind::bridges, LoopKind::handle),
                                     std::pair(RepairKind::tunnels, LoopKind::tunnel)}) {
      std::vector<Vec3> positions;
      for (const Handle& h : removal.removed)
        if (h.kind == loop) positions.push_back(h.position);
      note(kind, std::move(positions));
    }
    report_.removed_handles = std::move(removal.removed);
    report_.canal = removal.canal;
  }

  RepairedMesh result() {
    if (const auto obstacle = obstacle_to_model(inspect_mesh(now_.mesh.soup())))
      throw InvalidInput(obstacle->finding + " after repair; " + obstacle->advice);
    std::stable_sort(report_.changes.begin(), report_.changes.end(),
                     [](const RepairChange& a, const RepairChange& b) { return a.kind < b.kind; });
    RepairedMesh out{now_.mesh, std::move(report_), now_.origin,
                     VertexMap<VertexId>(static_cast<int>(raw_.joined.size()))};
    for (VertexId v : out.mesh.vertices())
      if (const VertexId raw = out.origin[v]; raw.valid() && !out.repaired[raw].valid())
        out.repaired[raw] = v;
    for (VertexId raw : out.repaired.ids())
      out.repaired[raw] = out.repaired[VertexId(raw_.joined[raw.index])];
    return out;
  }

  RepairOptions options_;
  RunContext ctx_;
  RawSurface raw_;
  std::vector<DroppedPiece> dropped_;
  EditedMesh now_;
  std::vector<Vec3> reversed_, holes_;
  RepairReport report_;
};

}  // namespace

std::optional<VertexId> RepairedMesh::from_raw(VertexId raw) const {
  if (!raw.valid() || raw.index >= repaired.size() || !repaired[raw].valid()) return std::nullopt;
  return repaired[raw];
}

RepairedMesh repair_mesh(const TriangleSoup& raw, const RepairOptions& options, const RunContext& ctx) {
  return Repair(raw, options, ctx).run();
}

}  // namespace foramen
