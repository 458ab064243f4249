#pragma once
/// \file
/// The error of a correspondence against points and curves that people marked.

#include <optional>
#include <string>
#include <vector>

#include "foramen/core/marks.hpp"
#include "foramen/core/run_context.hpp"
#include "foramen/evaluate/cohort.hpp"
#include "foramen/evaluate/transfer_estimate.hpp"

namespace foramen {

/// The points of a mark that are compared.
enum class MarkPart {
  point,    ///< a single point
  start,    ///< of an open curve
  middle,   ///< of an open curve, by arc length
  end,      ///< of an open curve
  centroid  ///< of a closed curve, by arc length
};
template <>
struct EnumWords<MarkPart> {
  static constexpr std::pair<std::string_view, MarkPart> all[] = {{"point", MarkPart::point},
                                                                  {"start", MarkPart::start},
                                                                  {"middle", MarkPart::middle},
                                                                  {"end", MarkPart::end},
                                                                  {"centroid", MarkPart::centroid}};
};

/// The error of one point of a mark over all pairs in which both shapes have the mark, mm.
struct PointTransfer {
  std::string mark;
  MarkPart part = MarkPart::point;
  TransferEstimate error;
};
/// The error of a curve over all pairs in which both shapes have it, mm.
struct CurveTransfer {
  std::string mark;
  TransferEstimate error;
};

/// The means of one ordered pair of shapes, mm; unset if the two have no such mark in common.
struct MarkPair {
  int from = 0, to = 0;  ///< shapes of the cohort
  std::optional<double> points, curves;
};

/// A mean over pairs and the 95th percentile, mm.
struct TransferSummary {
  TransferEstimate error;  ///< mean over pairs of the mean of a pair
  double p95 = 0;          ///< of all single errors: the smallest that 95 % of them do not exceed
  int errors = 0;          ///< number of single errors
};

/// An open curve that most pairs would compare better from its other end.
struct ReversedCurve {
  int shape = 0;
  std::string mark;
};

/// A mark of one shape as points of its corresponding mesh. These points exist on every shape of the model,
/// so the mark can be drawn on each.
struct PlacedMark {
  std::string mark;
  MarkKind kind = MarkKind::point;
  int shape = 0;
  std::vector<SurfacePoint> places;  ///< closest to the marked point, or to 20 evenly spaced ones of a curve
};

/// The result of mark_transfer().
struct MarkTransfer {
  std::optional<TransferSummary> points, curves;  ///< unset: no two shapes have such a mark in common
  std::vector<PointTransfer> by_point;            ///< in the order in which marks first occur
  std::vector<CurveTransfer> by_curve;
  std::vector<MarkPair> pairs;         ///< by `from`, then by `to`
  int marked_shapes = 0;               ///< shapes with marks
  int incomplete_shapes = 0;           ///< of these, shapes that lack a mark that another one has
  std::vector<double> off_surface_mm;  ///< per shape: mean distance of its marks to its corresponding mesh
  std::vector<ReversedCurve> reversed;
  /// All marks, in the order in which they first occur, and of each mark by shape. The curves of a mark run
  /// in one direction, and closed ones start at about the same place.
  std::vector<PlacedMark> placed = {};
};

/// Carries every mark of shape A to shape B and compares it with the mark of the same name there, for all
/// ordered pairs of shapes of different subjects (of all shapes, if subjects are not known). A point is
/// carried from the closest point of A's corresponding mesh to the point with the same triangle and
/// barycentric coordinates of B's.
///
/// Points: the distance of a single point, of the two ends and the middle of an open curve, and of the
/// centroid of a closed curve (its carried points' centroid to the centroid of the curve on B). Curves: a
/// curve is resampled by arc length and 60 points of it are carried. The polyline through them and the
/// curve on B are each resampled at 120 points by arc length; the error is the average of the mean
/// distances of these points to the other polyline. Curves are compared in their own direction; see
/// MarkTransfer::reversed.
///
/// \param marks  one entry per shape; empty for a shape without marks
/// Throws InvalidInput if a mark has too few points for its kind, a name occurs twice on a shape or is of
/// another kind on another one, or no two shapes of different subjects have a mark in common.
MarkTransfer mark_transfer(const CorrespondingCohort& cohort, const std::vector<MarksOfShape>& marks,
                           const RunContext& ctx);

}  // namespace foramen
