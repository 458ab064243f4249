#include "sampling/refine_landmarks.hpp"

#include <algorithm>

#include "core/parallel.hpp"
#include "foramen/core/error.hpp"
#include "foramen/sampling/landmark_mesh.hpp"
#include "sampling/landmark_repairs.hpp"
#include "spatial/flips.hpp"
#include "spatial/self_intersections.hpp"

namespace foramen {
namespace {

using detail::Guilt;
using detail::GuiltTable;
using detail::Repair;
using detail::RepairKind;

/// What is repaired: flipped and degenerate triangles only, or intersecting triangles as well.
enum class Mending { flips, meetings };

/// Whether intersecting triangles count on a shape. They do if its input surface has no self-intersections,
/// which is tested only when the first intersecting triangles are found (input_unknown).
enum class Watch { off, input_unknown, on };

class Refinement {
 public:
  Refinement(const LandmarkMesh& landmarks, std::span<const LandmarkShape> shapes, Mending mending,
             const RunContext& ctx)
      : mesh_(landmarks.turns, landmarks.triangles, landmarks.jumps),
        shapes_(shapes),
        watch_(shapes.size(), mending == Mending::meetings ? Watch::input_unknown : Watch::off),
        lifted_(shapes, mesh_, ctx),
        ctx_(ctx),
        guilt_(shapes.size(), std::vector<Guilt>(landmarks.triangles.size())) {
    inspect_all();
  }

  /// Tests all triangles on all shapes by sampled_flips() and self_intersections(), which define the reported
  /// numbers.
  void inspect_all() {
    lifted_.measure_edges(mesh_);
    parallel_for(lifted_.shapes(), ctx_, [&](int s) {
      const SampledFlips found = sampled_flips(lifted_.corresponding(s, mesh_), *shapes_[s].tree);
      std::fill(guilt_[s].begin(), guilt_[s].end(), Guilt{});
      for (FaceId f : found.confirmed) guilt_[s][f.index].flipped = 1;
      for (FaceId f : found.degenerate) guilt_[s][f.index].flipped = 1;
      count_meetings(s);
    });
  }

  /// Guilt of all triangles on all shapes.
  Guilt guilt() const {
    Guilt sum;
    for (const auto& of_shape : guilt_)
      for (const Guilt& g : of_shape) sum = sum + g;
    return sum;
  }

  std::vector<int> guilty_faces() const {
    std::vector<int> faces;
    for (int f = 0; f < mesh_.face_slots(); ++f)
      if (std::any_of(guilt_.begin(), guilt_.end(),
                      [&](const auto& of_shape) { return of_shape[f] != Guilt{}; }))
        faces.push_back(f);
    return faces;
  }

  /// Makes one change at each of these faces if possible. Returns the number of changes.
  int repair(const std::vector<int>& faces, detail::Insertion insertion, int insertions_left,
             RefinedLandmarks& result) {
    std::vector<Repair> repairs(faces.size());
    parallel_for(static_cast<int>(faces.size()), ctx_, [&](int i) {
      repairs[i] = detail::best_repair(mesh_, lifted_, guilt_, faces[i], insertion);
    });
    std::vector<char> touched(mesh_.vertex_slots(), 0);
    std::vector<int> changed_faces;
    int changes = 0;
    for (const Repair& r : repairs) {
      const bool inserts = r.kind == RepairKind::split_edge || r.kind == RepairKind::split_face;
      if (r.kind == RepairKind::none || (inserts && insertions_left == 0)) continue;
      if (std::any_of(r.support.begin(), r.support.end(), [&](int v) { return touched[v] != 0; })) continue;
      const int centre = make(r, result);
      if (centre < 0) continue;
      if (inserts) --insertions_left;
      ++changes;
      for (int v : r.support) touched[v] = 1;
      mesh_.for_each_outgoing(centre, [&](int h) { changed_faces.push_back(h / 3); });
    }
    inspect(changed_faces);
    return changes;
  }

  LandmarkMesh landmark_mesh() const { return mesh_.landmark_mesh(); }

 private:
  /// Makes a change. Returns a vertex whose faces include all changed faces, or -1 if the change is
  /// impossible.
  int make(const Repair& r, RefinedLandmarks& result) {
    if (r.kind == RepairKind::flip) {
      if (!mesh_.can_flip(r.element)) return -1;
      ++result.flips;
      return mesh_.from(mesh_.flip(r.element));
    }
    if (r.kind == RepairKind::move) {
      mesh_.set_place(r.element, r.place);
      lifted_.update(r.element, r.place);
      ++result.moved;
      return r.element;
    }
    const int v =
        r.kind == RepairKind::split_edge ? mesh_.split_edge(r.element) : mesh_.split_face(r.element);
    if (v < 0) return -1;
    lifted_.update(v, mesh_.place(v));
    ++result.inserted;
    return v;
  }

  void inspect(std::vector<int>& faces) {
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    parallel_for(lifted_.shapes(), ctx_, [&](int s) {
      guilt_[s].resize(mesh_.face_slots());
      for (int f : faces) {
        const auto [a, b, c] = mesh_.corners(f);
        const bool flipped =
            lifted_.guilty(s, {lifted_.point(s, a), lifted_.point(s, b), lifted_.point(s, c)});
        guilt_[s][f] = {flipped, 0};
      }
      count_meetings(s);
    });
  }

  void count_meetings(int s) {
    if (watch_[s] == Watch::off) return;
    for (Guilt& g : guilt_[s]) g.meetings = 0;
    lifted_.refresh_surface(s, mesh_);
    const auto pairs = self_intersections(*lifted_.surface(s));
    if (!pairs.empty() && watch_[s] == Watch::input_unknown)
      watch_[s] = self_intersections(*shapes_[s].tree).empty() ? Watch::on : Watch::off;
    if (watch_[s] == Watch::off) return lifted_.forget_surface(s);
    for (const auto& [f, g] : pairs) {
      ++guilt_[s][f.index].meetings;
      ++guilt_[s][g.index].meetings;
    }
  }

  detail::TorusTriangulation mesh_;
  std::span<const LandmarkShape> shapes_;
  std::vector<Watch> watch_;
  detail::LiftedLandmarks lifted_;
  const RunContext& ctx_;
  GuiltTable guilt_;
};

/// Makes rounds of changes until no triangle is guilty or no change helps, and keeps the best state.
void mend(RefinedLandmarks& best, std::span<const LandmarkShape> shapes, Mending mending, int budget,
          int round_limit, const RunContext& ctx) {
  using detail::Insertion;
  Refinement state(best.landmarks, shapes, mending, ctx);
  Guilt least = state.guilt();
  if (mending == Mending::flips) best.initial = least.flipped;
  best.initial_self_intersections = least.meetings / 2;
  best.landmarks = state.landmark_mesh();
  // Remaining flips could not be repaired by earlier rounds.
  if (mending == Mending::meetings && least.meetings == 0) return;
  RefinedLandmarks result = best;
  bool must_help = true;
  for (int round = 0; least != Guilt{} && round < round_limit; ++round) {
    ctx.step("refine landmarks", double(round) / round_limit);
    const int left = budget - result.inserted;
    const Insertion insertion = left == 0 ? Insertion::none : must_help ? Insertion::helpful : Insertion::any;
    if (state.repair(state.guilty_faces(), insertion, left, result) == 0) {
      if (insertion != Insertion::helpful) break;
      // No change helps: a new landmark that does not lower the guilt may make other changes possible.
      must_help = false;
      continue;
    }
    must_help = true;
    // The mean edge length has changed slightly since the last complete test, so all triangles are tested
    // again by sampled_flips().
    if (state.guilt() == Guilt{}) state.inspect_all();
    const Guilt now = state.guilt();
    if (now >= least) continue;
    least = now;
    best = result;
    best.landmarks = state.landmark_mesh();
  }
  if (least != Guilt{}) least = Refinement(best.landmarks, shapes, mending, ctx).guilt();
  best.remaining = least.flipped;
  best.remaining_self_intersections = least.meetings / 2;
}

}  // namespace

RefinedLandmarks refine_landmarks(const LandmarkMesh& landmarks, std::span<const LandmarkShape> shapes,
                                  const RunContext& ctx, const RefineLandmarksOptions& options) {
  if (!(options.budget >= 0)) throw InvalidInput("refine landmarks: the budget must not be negative");
  const int budget = static_cast<int>(options.budget * static_cast<double>(landmarks.turns.size()));
  RefinedLandmarks result;
  result.landmarks = landmarks;
  mend(result, shapes, Mending::flips, budget, options.round_limit, ctx);
  mend(result, shapes, Mending::meetings, budget, options.round_limit, ctx);
  return result;
}

}  // namespace foramen
