#include "repair/part_sheets.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

#include "foramen/core/geometry.hpp"
#include "repair/disk.hpp"
#include "repair/embedded.hpp"
#include "repair/meeting_places.hpp"
#include "repair/patching.hpp"

namespace foramen {
namespace {

using namespace repair_detail;

// Tried shifts, relative to the largest allowed move.
constexpr std::array shifts{1.0 / 16, 1.0 / 8, 1.0 / 4, 1.0 / 2, 1.0};
// Largest width of a part that is cut out, in rings of triangles, and largest number of parts.
constexpr int most_rings = 3, most_cuts = 50;
// Rounds of averaging over neighbours, after which the normals are those of the wall rather than of its
// dents.
constexpr int normal_smoothing = 3;

VertexMap<Vec3> wall_normals(const Mesh& mesh) {
  VertexMap<Vec3> normals = vertex_normals(mesh);
  for (int round = 0; round < normal_smoothing; ++round) {
    VertexMap<Vec3> sum = normals;
    for (HalfedgeId h : mesh.halfedges()) sum[mesh.from(h)] += normals[mesh.to(h)];
    for (VertexId v : mesh.vertices()) normals[v] = sum[v].normalized();
  }
  return normals;
}

// A repair that proposes new positions for the vertices of all places.
using Remedy = std::function<std::vector<Vec3>(const Mesh&, const MeetingPlaces&)>;

Remedy shifted(double distance_mm) {
  return [distance_mm](const Mesh& mesh, const MeetingPlaces& places) {
    std::vector<Vec3> moved(mesh.positions().begin(), mesh.positions().end());
    const VertexMap<Vec3> normals = wall_normals(mesh);
    for (VertexId v : mesh.vertices()) {
      const int ring = places.ring[v];
      if (ring < 0) continue;
      const double share = 1 - static_cast<double>(ring) / (place_rings + 1);
      moved[v.index] += share * distance_mm * normals[v];
    }
    return moved;
  };
}

Remedy smoothed(int rings) {
  return [rings](const Mesh& mesh, const MeetingPlaces& places) {
    std::vector<VertexId> free;
    for (VertexId v : mesh.vertices())
      if (places.ring[v] >= 0 && places.ring[v] <= rings) free.push_back(v);
    return faired(mesh, free, Fairness::thin_plate);
  };
}

std::vector<Remedy> remedies(double largest_move_mm) {
  std::vector<Remedy> all;
  for (std::size_t k = 0; k < shifts.size(); ++k) {
    all.push_back(shifted(shifts[k] * largest_move_mm));
    all.push_back(shifted(-shifts[k] * largest_move_mm));
    if (k < place_rings) all.push_back(smoothed(static_cast<int>(k)));
  }
  return all;
}

class Parting {
 public:
  Parting(const Mesh& mesh, const PartSheetsOptions& options)
      : options_(options), now_(unchanged(mesh)), pairs_(meeting_pairs(mesh)) {}

  bool done() const { return pairs_.empty(); }

  // Applies the remedy in the places where it removes all intersections, if this lowers the number of
  // intersecting pairs.
  void attempt(const Remedy& remedy) {
    const MeetingPlaces places(now_.mesh, pairs_);
    const std::vector<Vec3> trial = remedy(now_.mesh, places);
    std::vector<char> helped(places.count, 1);
    for (VertexId v : now_.mesh.vertices())
      if (places.of_vertex[v] >= 0 && move(v, trial) > options_.largest_move_mm)
        helped[places.of_vertex[v]] = 0;
    for (const auto& [f, g] : meeting_pairs(now_.mesh.with_positions(trial)))
      for (FaceId face : {f, g})
        if (places.of_face[face] >= 0) helped[places.of_face[face]] = 0;

    std::vector<Vec3> taken(now_.mesh.positions().begin(), now_.mesh.positions().end());
    for (VertexId v : now_.mesh.vertices())
      if (const int p = places.of_vertex[v]; p >= 0 && helped[p] != 0) taken[v.index] = trial[v.index];
    const Mesh mesh = now_.mesh.with_positions(taken);
    auto pairs = meeting_pairs(mesh);
    if (pairs.size() >= pairs_.size()) return;
    for (VertexId v : now_.mesh.vertices()) largest_move_ = std::max(largest_move_, move(v, taken));
    note_parted(places, helped);
    now_.mesh = mesh;
    pairs_ = std::move(pairs);
  }

  // Cuts a place out and closes it by disks, as narrowly as lowers the number of intersecting pairs. False if
  // no width does.
  bool cut_out(int place) {
    const MeetingPlaces places(now_.mesh, pairs_);
    FaceSet faces(now_.mesh.face_count(), 0);
    for (const auto& [f, g] : pairs_)
      if (places.of_face[f] == place) faces[f] = faces[g] = 1;
    for (int ring = 0; ring < most_rings; ++ring, faces = grown(now_.mesh, faces)) {
      const auto open = without_faces(now_.mesh, faces);
      if (!open) return false;
      const auto holes = borders(open->mesh);
      if (std::any_of(holes.begin(), holes.end(),
                      [](const Border& b) { return b.size() > most_loop_points; }))
        return false;
      for (Fairness fairness : {Fairness::thin_plate, Fairness::membrane}) {
        const Mesh closed = with_disks(open->mesh, fairness);
        if (closed.euler_characteristic() != now_.mesh.euler_characteristic()) break;
        auto pairs = meeting_pairs(closed);
        if (pairs.size() >= pairs_.size()) continue;
        std::vector<char> helped(places.count, 0);
        helped[place] = 1;
        note_parted(places, helped);
        VertexMap<VertexId> origin = open->origin;
        origin.values().resize(closed.vertex_count());
        now_ = {closed, composed(now_.origin, origin)};
        pairs_ = std::move(pairs);
        return true;
      }
    }
    return false;
  }

  void cut_out_all() {
    int kept = 0;  // places that cannot be repaired
    for (int cut = 0; cut < most_cuts && kept < MeetingPlaces(now_.mesh, pairs_).count; ++cut)
      if (!cut_out(kept)) ++kept;
  }

  PartedSheets result() const {
    PartedSheets out{now_.mesh, now_.origin, parted_, {}, largest_move_};
    for (const auto& pair : pairs_) out.remaining.push_back(middle(pair));
    return out;
  }

 private:
  double move(VertexId v, const std::vector<Vec3>& positions) const {
    return (positions[v.index] - now_.mesh.position(v)).norm();
  }

  Vec3 middle(const std::pair<FaceId, FaceId>& pair) const {
    Vec3 sum = Vec3::Zero();
    for (FaceId f : {pair.first, pair.second})
      for (const Vec3& p : now_.mesh.triangle(f)) sum += p / 6;
    return sum;
  }

  void note_parted(const MeetingPlaces& places, const std::vector<char>& helped) {
    for (const auto& pair : pairs_)
      if (helped[places.of_face[pair.first]] != 0) parted_.push_back(middle(pair));
  }

  PartSheetsOptions options_;
  EditedMesh now_;
  std::vector<std::pair<FaceId, FaceId>> pairs_;
  std::vector<Vec3> parted_;
  double largest_move_ = 0;
};

}  // namespace

PartedSheets part_sheets(const Mesh& mesh, const PartSheetsOptions& options) {
  Parting parting(mesh, options);
  for (const Remedy& remedy : remedies(options.largest_move_mm)) {
    if (parting.done()) break;
    parting.attempt(remedy);
  }
  if (!parting.done()) parting.cut_out_all();
  return parting.result();
}

}  // namespace foramen
