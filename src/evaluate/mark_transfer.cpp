#include "foramen/evaluate/mark_transfer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "core/parallel.hpp"
#include "evaluate/placed_curves.hpp"
#include "evaluate/polyline.hpp"
#include "evaluate/subject_pairs.hpp"
#include "foramen/core/error.hpp"
#include "foramen/spatial/triangle_tree.hpp"
#include "spatial/percentile.hpp"

namespace foramen {
namespace {

using detail::PairSubjects;
using detail::PairValue;
using detail::Polyline;

constexpr int carried_points = 60, compared_points = 120, placed_points = 20;
constexpr std::array open_parts{MarkPart::start, MarkPart::middle, MarkPart::end};

/// A mark as it is carried and compared.
struct PreparedMark {
  MarkKind kind = MarkKind::point;
  std::vector<Vec3> points;          // one per part, see parts_of()
  std::vector<SurfacePoint> places;  // of the points on the corresponding mesh; none for a centroid
  std::vector<SurfacePoint> curve;   // the carried points of a curve
  std::vector<SurfacePoint> shown;   // see PlacedMark::places
  std::optional<Polyline> marked;    // the curve itself
};
using PreparedMarks = std::map<std::string, PreparedMark>;

std::vector<MarkPart> parts_of(MarkKind kind) {
  if (kind == MarkKind::open_curve) return {open_parts.begin(), open_parts.end()};
  return {kind == MarkKind::point ? MarkPart::point : MarkPart::centroid};
}

std::string quoted_on(const std::string& mark, const std::string& shape) {
  return "the mark '" + mark + "' of " + shape;
}

void check_marks(const CorrespondingCohort& cohort, const std::vector<MarksOfShape>& marks) {
  if (marks.size() != cohort.corresponding.size())
    throw InvalidInput("found marks of " + std::to_string(marks.size()) + " shapes for " +
                       std::to_string(cohort.size()) +
                       " corresponding shapes: there must be an entry for each");
  std::map<std::string, std::pair<MarkKind, std::string>> first;  // of each mark: its kind and shape
  for (std::size_t s = 0; s < marks.size(); ++s) {
    std::set<std::string> names;
    for (const Mark& mark : marks[s]) {
      const std::string where = quoted_on(mark.name, cohort.names[s]);
      if (!names.insert(mark.name).second) throw InvalidInput(where + " occurs twice: rename one of them");
      const std::size_t fewest = mark.kind == MarkKind::point ? 1 : mark.kind == MarkKind::open_curve ? 2 : 3;
      const bool fits = mark.kind == MarkKind::point ? mark.points.size() == 1 : mark.points.size() >= fewest;
      if (!fits)
        throw InvalidInput(where + " has " + std::to_string(mark.points.size()) + " points, but its kind '" +
                           std::string(word_of(mark.kind)) + "' needs " + std::to_string(fewest) +
                           (mark.kind == MarkKind::point ? "" : " or more") + ": correct it");
      for (const Vec3& p : mark.points)
        if (!p.allFinite()) throw InvalidInput(where + " has a coordinate that is not finite: correct it");
      const auto [of_name, is_new] = first.try_emplace(mark.name, mark.kind, cohort.names[s]);
      if (!is_new && of_name->second.first != mark.kind)
        throw InvalidInput(where + " is of the kind '" + std::string(word_of(mark.kind)) + "', that of " +
                           of_name->second.second + " '" + std::string(word_of(of_name->second.first)) +
                           "': give both the same kind, or other names");
    }
  }
}

/// The names of all marks in the order in which they first occur, with their kinds.
std::vector<std::pair<std::string, MarkKind>> all_marks(const std::vector<MarksOfShape>& marks) {
  std::vector<std::pair<std::string, MarkKind>> all;
  std::set<std::string> seen;
  for (const MarksOfShape& of_shape : marks)
    for (const Mark& mark : of_shape)
      if (seen.insert(mark.name).second) all.emplace_back(mark.name, mark.kind);
  return all;
}

/// Finds the places of marks on the corresponding mesh of their shape.
class MarkPlacer {
 public:
  explicit MarkPlacer(const Mesh& mesh) : tree_(mesh, TreeNormals::none) {}

  PreparedMark prepared(const Mark& mark) {
    PreparedMark result;
    result.kind = mark.kind;
    if (mark.kind == MarkKind::point) {
      result.points = mark.points;
      for (const Vec3& p : mark.points) result.places.push_back(place(p));
      result.shown = result.places;
      return result;
    }
    const Polyline& curve = result.marked.emplace(mark.points, mark.kind == MarkKind::closed_curve);
    for (const Vec3& p : curve.resampled(carried_points)) result.curve.push_back(place(p));
    for (const Vec3& p : curve.resampled(placed_points)) result.shown.push_back(tree_.closest(p).on);
    if (mark.kind == MarkKind::closed_curve) {
      result.points = {curve.centroid()};
      return result;
    }
    for (const double share : {0.0, 0.5, 1.0}) {
      result.points.push_back(curve.at(share));
      result.places.push_back(tree_.closest(result.points.back()).on);
    }
    return result;
  }
  /// The mean distance to the mesh of all points placed so far.
  double mean_distance() const { return placed_ > 0 ? sum_ / placed_ : 0; }

 private:
  SurfacePoint place(const Vec3& p) {
    const ClosestPoint closest = tree_.closest(p);
    sum_ += std::sqrt(closest.squared_distance);
    ++placed_;
    return closest.on;
  }

  TriangleTree tree_;
  double sum_ = 0;
  int placed_ = 0;
};

/// The points of a mark and its curve, carried to another shape.
struct CarriedMark {
  std::vector<Vec3> points;
  std::optional<Polyline> curve;
};

CarriedMark carried(const PreparedMark& mark, const Mesh& to) {
  CarriedMark result;
  for (const SurfacePoint& place : mark.places) result.points.push_back(position(to, place));
  if (mark.kind == MarkKind::point) return result;
  std::vector<Vec3> curve;
  for (const SurfacePoint& place : mark.curve) curve.push_back(position(to, place));
  result.curve.emplace(curve, mark.kind == MarkKind::closed_curve);
  if (mark.kind == MarkKind::closed_curve) result.points = {result.curve->centroid()};
  return result;
}

/// The errors of one mark in one pair.
struct MarkErrors {
  std::vector<double> points;
  std::optional<double> curve;
  bool reversed = false;  // an open curve whose ends are closer to the other ends of the mark
};

MarkErrors errors_of(const PreparedMark& from, const PreparedMark& to, const Mesh& mesh) {
  const CarriedMark here = carried(from, mesh);
  MarkErrors errors;
  for (std::size_t i = 0; i < here.points.size(); ++i)
    errors.points.push_back((here.points[i] - to.points[i]).norm());
  if (here.curve) errors.curve = detail::mean_distance(*here.curve, *to.marked, compared_points);
  if (from.kind == MarkKind::open_curve)
    errors.reversed =
        (here.points.front() - to.points.back()).norm() + (here.points.back() - to.points.front()).norm() <
        errors.points.front() + errors.points.back();
  return errors;
}

/// One mark on all shapes that have it; its curves run as that of the first of them.
std::vector<PlacedMark> placed_on_all(const std::string& name, MarkKind kind,
                                      const std::vector<PreparedMarks>& prepared,
                                      const std::vector<Mesh>& meshes) {
  std::vector<PlacedMark> placed;
  for (std::size_t s = 0; s < prepared.size(); ++s) {
    const auto found = prepared[s].find(name);
    if (found == prepared[s].end()) continue;
    std::vector<SurfacePoint> places = found->second.shown;
    if (kind != MarkKind::point && !placed.empty())
      places = detail::run_alike(places, placed[0].places, kind == MarkKind::closed_curve,
                                 meshes[placed[0].shape]);
    placed.push_back({name, kind, static_cast<int>(s), std::move(places)});
  }
  return placed;
}

/// Collects the errors of all pairs.
class TransferTable {
 public:
  TransferTable(std::vector<std::pair<std::string, MarkKind>> marks, const PairSubjects& subjects)
      : marks_(std::move(marks)), subjects_(subjects) {}

  void add(MarkPair pair, const std::map<std::string, MarkErrors>& errors) {
    double points = 0, curves = 0;
    int point_count = 0, curve_count = 0;
    for (const auto& [name, of_mark] : errors) {
      for (std::size_t part = 0; part < of_mark.points.size(); ++part) {
        by_point_[{name, part}].push_back({pair.from, pair.to, of_mark.points[part]});
        all_points_.push_back(of_mark.points[part]);
        points += of_mark.points[part];
        ++point_count;
      }
      if (of_mark.curve) {
        by_curve_[name].push_back({pair.from, pair.to, *of_mark.curve});
        all_curves_.push_back(*of_mark.curve);
        curves += *of_mark.curve;
        ++curve_count;
      }
      for (const int shape : {pair.from, pair.to}) {
        auto& [reversed, compared] = directions_[{shape, name}];
        reversed += of_mark.reversed ? 1 : 0;
        ++compared;
      }
    }
    if (point_count > 0) points_of_pairs_.push_back({pair.from, pair.to, points / point_count});
    if (curve_count > 0) curves_of_pairs_.push_back({pair.from, pair.to, curves / curve_count});
    if (point_count > 0) pair.points = points / point_count;
    if (curve_count > 0) pair.curves = curves / curve_count;
    pairs_.push_back(pair);
  }

  MarkTransfer result() const {
    MarkTransfer transfer;
    transfer.pairs = pairs_;
    transfer.points = summary(points_of_pairs_, all_points_);
    transfer.curves = summary(curves_of_pairs_, all_curves_);
    for (const auto& [name, kind] : marks_) {
      const std::vector<MarkPart> parts = parts_of(kind);
      for (std::size_t part = 0; part < parts.size(); ++part)
        if (const auto found = by_point_.find({name, part}); found != by_point_.end())
          transfer.by_point.push_back({name, parts[part], mean_over_pairs(found->second, subjects_)});
      if (const auto found = by_curve_.find(name); found != by_curve_.end())
        transfer.by_curve.push_back({name, mean_over_pairs(found->second, subjects_)});
    }
    for (const auto& [curve, counts] : directions_)
      if (2 * counts.first > counts.second) transfer.reversed.push_back({curve.first, curve.second});
    return transfer;
  }

 private:
  std::optional<TransferSummary> summary(const std::vector<PairValue>& of_pairs,
                                         const std::vector<double>& all) const {
    if (all.empty()) return std::nullopt;
    return TransferSummary{mean_over_pairs(of_pairs, subjects_), detail::percentile_95(all),
                           static_cast<int>(all.size())};
  }

  std::vector<std::pair<std::string, MarkKind>> marks_;
  const PairSubjects& subjects_;
  std::vector<MarkPair> pairs_;
  std::vector<PairValue> points_of_pairs_, curves_of_pairs_;
  std::vector<double> all_points_, all_curves_;
  std::map<std::pair<std::string, std::size_t>, std::vector<PairValue>> by_point_;
  std::map<std::string, std::vector<PairValue>> by_curve_;
  std::map<std::pair<int, std::string>, std::pair<int, int>> directions_;  // reversed pairs, and all pairs
};

}  // namespace

MarkTransfer mark_transfer(const CorrespondingCohort& cohort, const std::vector<MarksOfShape>& marks,
                           const RunContext& ctx) {
  check_cohort(cohort);
  check_marks(cohort, marks);
  const int shapes = cohort.size();
  std::vector<Mesh> meshes(shapes);
  std::vector<PreparedMarks> prepared(shapes);
  std::vector<double> off_surface(shapes, 0.0);
  parallel_for(shapes, ctx, [&](int s) {
    if (marks[s].empty()) return;
    meshes[s] = corresponding_mesh(cohort, s);
    MarkPlacer placer(meshes[s]);
    for (const Mark& mark : marks[s]) prepared[s].emplace(mark.name, placer.prepared(mark));
    off_surface[s] = placer.mean_distance();
  });

  const PairSubjects subjects(shapes, cohort.subjects);
  std::vector<std::vector<std::pair<int, std::map<std::string, MarkErrors>>>> errors(shapes);  // by `from`
  parallel_for(shapes, ctx, [&](int from) {
    for (int to = 0; to < shapes; ++to) {
      if (!subjects.differ(from, to)) continue;
      std::map<std::string, MarkErrors> of_pair;
      for (const auto& [name, mark] : prepared[from])
        if (const auto there = prepared[to].find(name); there != prepared[to].end())
          of_pair.emplace(name, errors_of(mark, there->second, meshes[to]));
      if (!of_pair.empty()) errors[from].emplace_back(to, std::move(of_pair));
    }
  });

  const auto names = all_marks(marks);
  TransferTable table(names, subjects);
  for (int from = 0; from < shapes; ++from)
    for (const auto& [to, of_pair] : errors[from]) table.add({from, to, {}, {}}, of_pair);
  MarkTransfer transfer = table.result();
  if (transfer.pairs.empty())
    throw InvalidInput(
        "no two shapes of different subjects have a mark in common: give marks of the same names on at least "
        "two shapes, and check their subjects");
  transfer.off_surface_mm = std::move(off_surface);
  for (const auto& [name, kind] : names)
    for (PlacedMark& mark : placed_on_all(name, kind, prepared, meshes))
      transfer.placed.push_back(std::move(mark));
  for (const MarksOfShape& of_shape : marks) {
    if (of_shape.empty()) continue;
    ++transfer.marked_shapes;
    if (of_shape.size() < names.size()) ++transfer.incomplete_shapes;
  }
  return transfer;
}

}  // namespace foramen
