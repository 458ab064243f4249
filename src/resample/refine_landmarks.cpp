#include "foramen/resample/refine_landmarks.hpp"

#include <algorithm>

#include "foramen/core/error.hpp"
#include "foramen/core/parallel.hpp"
#include "foramen/spatial/flips.hpp"
#include "resample/landmark_repairs.hpp"

namespace foramen {
namespace {

using detail::GuiltTable;
using detail::Repair;
using detail::RepairKind;

class Refinement {
 public:
  Refinement(const LandmarkMesh& landmarks, std::span<const LandmarkShape> shapes, const RunContext& ctx)
      : mesh_(landmarks.turns, landmarks.triangles, landmarks.jumps),
        shapes_(shapes),
        lifted_(shapes, mesh_, ctx),
        ctx_(ctx),
        guilt_(shapes.size(), std::vector<char>(landmarks.triangles.size(), 0)) {}

  /// Every triangle of every shape, by the definition that is reported. Returns the number of guilty ones.
  int inspect_all() {
    lifted_.measure_edges(mesh_);
    parallel_for(lifted_.shapes(), ctx_, [&](int s) {
      const SampledFlips found = sampled_flips(lifted_.corresponding(s, mesh_), *shapes_[s].tree);
      std::fill(guilt_[s].begin(), guilt_[s].end(), char{0});
      for (FaceId f : found.confirmed) guilt_[s][f.index] = 1;
      for (FaceId f : found.degenerate) guilt_[s][f.index] = 1;
    });
    return guilty_count();
  }

  int guilty_count() const {
    std::ptrdiff_t count = 0;
    for (const auto& of_shape : guilt_) count += std::count(of_shape.begin(), of_shape.end(), char{1});
    return static_cast<int>(count);
  }

  std::vector<int> guilty_faces() const {
    std::vector<int> faces;
    for (int f = 0; f < mesh_.face_slots(); ++f)
      if (std::any_of(guilt_.begin(), guilt_.end(), [&](const auto& of_shape) { return of_shape[f] != 0; }))
        faces.push_back(f);
    return faces;
  }

  /// One change at each of these faces, where possible. Returns the number of changes.
  int repair(const std::vector<int>& faces, detail::Insertion insertion, int insertions_left,
             RefinedLandmarks& result) {
    std::vector<Repair> repairs(faces.size());
    parallel_for(static_cast<int>(faces.size()), ctx_, [&](int i) {
      repairs[i] = detail::best_repair(mesh_, lifted_, guilt_, faces[i], insertion);
    });
    std::vector<char> touched(static_cast<std::size_t>(mesh_.vertex_slots()), 0);
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
  /// Makes the change; returns a vertex whose faces include all changed ones, or -1 if it was impossible.
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
      guilt_[s].resize(static_cast<std::size_t>(mesh_.face_slots()), 0);
      for (int f : faces) {
        const auto [a, b, c] = mesh_.corners(f);
        guilt_[s][f] = lifted_.guilty(s, {lifted_.point(s, a), lifted_.point(s, b), lifted_.point(s, c)});
      }
    });
  }

  detail::TorusTriangulation mesh_;
  std::span<const LandmarkShape> shapes_;
  detail::LiftedLandmarks lifted_;
  const RunContext& ctx_;
  GuiltTable guilt_;
};

}  // namespace

RefinedLandmarks refine_landmarks(const LandmarkMesh& landmarks, std::span<const LandmarkShape> shapes,
                                  const RunContext& ctx, const RefineLandmarksOptions& options) {
  using detail::Insertion;
  if (!(options.budget >= 0)) throw InvalidInput("refine landmarks: the budget must not be negative");
  const int budget = static_cast<int>(options.budget * static_cast<double>(landmarks.turns.size()));
  Refinement state(landmarks, shapes, ctx);
  RefinedLandmarks result;
  result.landmarks = state.landmark_mesh();
  result.initial = result.remaining = state.inspect_all();
  RefinedLandmarks best = result;
  bool must_help = true;
  for (int round = 0; result.remaining > 0 && round < options.round_limit; ++round) {
    ctx.step("refine landmarks", double(round) / options.round_limit);
    const int left = budget - result.inserted;
    const Insertion insertion = left == 0 ? Insertion::none : must_help ? Insertion::helpful : Insertion::any;
    if (state.repair(state.guilty_faces(), insertion, left, result) == 0) {
      if (insertion != Insertion::helpful) break;
      must_help = false;  // stuck: a landmark that does not help by itself may open a way
      continue;
    }
    must_help = true;
    result.remaining = state.guilty_count();
    // The mean edge has changed a little since the last look at everything: the last word is
    // sampled_flips()'s.
    if (result.remaining == 0) result.remaining = state.inspect_all();
    if (result.remaining >= best.remaining) continue;
    best = result;
    best.landmarks = state.landmark_mesh();
  }
  if (best.remaining > 0) best.remaining = Refinement(best.landmarks, shapes, ctx).inspect_all();
  return best;
}

}  // namespace foramen
