#include "modelfiles/marks_json.hpp"

#include <algorithm>
#include <optional>

#include <nlohmann/json.hpp>

#include "foramen/core/error.hpp"

namespace foramen {
namespace {

using nlohmann::ordered_json;
using Names = std::vector<std::string>;

constexpr const char* pairs_definition =
    "all ordered pairs of shapes of different subjects (of all shapes, if subjects are not known)";
constexpr const char* error_definition =
    "jackknife over subjects: all pairs of a subject are left out together; null for fewer than three subjects";

ordered_json optional_json(const std::optional<double>& value) {
  return value ? ordered_json(*value) : ordered_json();
}

std::optional<double> optional_from(const ordered_json& json) {
  if (json.is_null()) return std::nullopt;
  return json.get<double>();
}

ordered_json to_json(const TransferEstimate& e) {
  return {{"mean", e.mean}, {"standard_error", optional_json(e.standard_error)}, {"pairs", e.pairs}};
}

TransferEstimate transfer_from(const ordered_json& j) {
  return {j.at("mean"), optional_from(j.at("standard_error")), j.at("pairs")};
}

ordered_json to_json(const std::optional<TransferSummary>& summary) {
  if (!summary) return {};
  ordered_json json = to_json(summary->error);
  json["p95"] = summary->p95;
  json["errors"] = summary->errors;
  return json;
}

std::optional<TransferSummary> transfer_summary_from(const ordered_json& j) {
  if (j.is_null()) return std::nullopt;
  return TransferSummary{transfer_from(j), j.at("p95"), j.at("errors")};
}

// The estimate, after what it is of.
template <class... Fields>
ordered_json named(const TransferEstimate& estimate, Fields... fields) {
  ordered_json json = ordered_json::object();
  (json.emplace(fields.first, fields.second), ...);
  json.update(to_json(estimate));
  return json;
}

int shape_index(const std::string& name, const Names& names) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw IoError("metrics.json: a pair or mark of the shape " + name +
                      ", which is not among its names; an evaluation of the model writes it anew",
                  {{RemedyKind::evaluate_model}});
  return static_cast<int>(found - names.begin());
}

MarkPart part_from(const ordered_json& json) {
  const auto part = value_of<MarkPart>(json.get<std::string>());
  if (!part) throw IoError("metrics.json: " + json.dump() + " is no part of a mark");
  return *part;
}

}  // namespace

ordered_json marks_json(const MarkTransfer& marks, const Names& names) {
  ordered_json points = ordered_json::array(), curves = points, pairs = points, reversed = points;
  for (const PointTransfer& p : marks.by_point)
    points.push_back(named(p.error, std::pair("mark", p.mark), std::pair("part", word_of(p.part))));
  for (const CurveTransfer& c : marks.by_curve) curves.push_back(named(c.error, std::pair("mark", c.mark)));
  for (const MarkPair& p : marks.pairs)
    pairs.push_back({{"from", names[p.from]},
                     {"to", names[p.to]},
                     {"points_mm", optional_json(p.points)},
                     {"curves_mm", optional_json(p.curves)}});
  for (const ReversedCurve& r : marks.reversed)
    reversed.push_back({{"shape", names[r.shape]}, {"mark", r.mark}});
  return {
      {"definition",
       "marks of shape A, carried from the closest point of its corresponding mesh to shape B, against B's "
       "marks of the same name. points: distance of single points, of the two ends and the middle of open "
       "curves, and of the centroid of closed ones. curves: mean of the mean distances both ways, of "
       "120 points each by arc length, of 60 points carried"},
      {"unit", "mm"},
      {"pairs_definition", pairs_definition},
      {"standard_error_definition", error_definition},
      {"marked_shapes", marks.marked_shapes},
      {"incomplete_shapes", marks.incomplete_shapes},
      {"points", to_json(marks.points)},
      {"curves", to_json(marks.curves)},
      {"by_point", points},
      {"by_curve", curves},
      {"off_surface_mm", marks.off_surface_mm},
      {"reversed", reversed},
      {"pairs", pairs}};
}

MarkTransfer marks_from(const ordered_json& j, const Names& names) {
  MarkTransfer marks;
  marks.points = transfer_summary_from(j.at("points"));
  marks.curves = transfer_summary_from(j.at("curves"));
  for (const ordered_json& p : j.at("by_point"))
    marks.by_point.push_back({p.at("mark"), part_from(p.at("part")), transfer_from(p)});
  for (const ordered_json& c : j.at("by_curve")) marks.by_curve.push_back({c.at("mark"), transfer_from(c)});
  for (const ordered_json& p : j.at("pairs"))
    marks.pairs.push_back({shape_index(p.at("from"), names), shape_index(p.at("to"), names),
                           optional_from(p.at("points_mm")), optional_from(p.at("curves_mm"))});
  marks.marked_shapes = j.at("marked_shapes");
  marks.incomplete_shapes = j.at("incomplete_shapes");
  marks.off_surface_mm = j.at("off_surface_mm").get<std::vector<double>>();
  for (const ordered_json& r : j.at("reversed"))
    marks.reversed.push_back({shape_index(r.at("shape"), names), r.at("mark")});
  return marks;
}

ordered_json regions_json(const RegionTransfer& regions, const Names& names) {
  ordered_json by_region = ordered_json::array(), pairs = by_region;
  for (const RegionOverlap& r : regions.by_region)
    by_region.push_back(named(r.dice, std::pair("region", r.region)));
  for (const RegionPair& p : regions.pairs)
    pairs.push_back({{"from", names[p.from]}, {"to", names[p.to]}, {"dice", p.dice}});
  return {
      {"definition",
       "Dice coefficient of each region in correspondence: every vertex of the corresponding mesh has the "
       "label of the closest vertex of the input, and weighs the mean of its areas on the two shapes; mean "
       "over pairs, then over regions"},
      {"unit", "share"},
      {"pairs_definition", pairs_definition},
      {"standard_error_definition", error_definition},
      {"labelled_shapes", regions.labelled_shapes},
      {"dice", to_json(regions.dice)},
      {"by_region", by_region},
      {"pairs", pairs}};
}

RegionTransfer regions_from(const ordered_json& j, const Names& names) {
  RegionTransfer regions;
  regions.dice = transfer_from(j.at("dice"));
  for (const ordered_json& r : j.at("by_region"))
    regions.by_region.push_back({r.at("region"), transfer_from(r)});
  for (const ordered_json& p : j.at("pairs"))
    regions.pairs.push_back({shape_index(p.at("from"), names), shape_index(p.at("to"), names), p.at("dice")});
  regions.labelled_shapes = j.at("labelled_shapes");
  return regions;
}

}  // namespace foramen
