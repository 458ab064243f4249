#include "modelfiles/marks_json.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <utility>

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

// Barycentric weights are written as whole numbers of this unit; the third is what the two others leave.
constexpr int weight_units = 10000;

ordered_json placed_json(const std::vector<PlacedMark>& placed, const Names& names) {
  ordered_json out = ordered_json::array();
  for (const PlacedMark& mark : placed) {
    ordered_json triangles = ordered_json::array(), weights = triangles;
    for (const SurfacePoint& place : mark.places) {
      triangles.push_back(place.face.index);
      int left = weight_units;
      for (int k = 0; k < 2; ++k) {
        const int weight =
            std::clamp(static_cast<int>(std::lround(weight_units * place.barycentric[k])), 0, left);
        weights.push_back(weight);
        left -= weight;
      }
    }
    out.push_back({{"mark", mark.mark},
                   {"kind", word_of(mark.kind)},
                   {"shape", names[mark.shape]},
                   {"triangles", triangles},
                   {"weights", weights}});
  }
  return out;
}

// Throws IoError if it is no whole number from 0 to `most`.
int whole_number(const ordered_json& json, int most) {
  const bool whole = json.is_number_integer() && json.get<std::int64_t>() >= 0 &&
                     json.get<std::int64_t>() <= most;  // those above the range of int64 become negative
  if (!whole)
    throw IoError("metrics.json: a place of a mark has the number " + json.dump() +
                  ", which is not whole and from 0 to " + std::to_string(most));
  return json.get<int>();
}

std::vector<SurfacePoint> places_from(const ordered_json& triangles, const ordered_json& weights) {
  if (!triangles.is_array() || !weights.is_array() || weights.size() != 2 * triangles.size())
    throw IoError("metrics.json: a mark's places need two weights for each triangle");
  std::vector<SurfacePoint> places;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const int first = whole_number(weights[2 * i], weight_units);
    const int second = whole_number(weights[2 * i + 1], weight_units - first);
    places.push_back(
        {FaceId(whole_number(triangles[i], std::numeric_limits<int>::max())),
         Vec3(first, second, weight_units - first - second) / static_cast<double>(weight_units)});
  }
  return places;
}

// The marks of one name have one kind and the same number of places: one of a point, more of a curve.
std::vector<PlacedMark> placed_from(const ordered_json& j, const Names& names) {
  std::vector<PlacedMark> placed;
  std::map<std::string, std::pair<MarkKind, std::size_t>> first;  // of each name: kind and places
  for (const ordered_json& p : j) {
    const auto kind = value_of<MarkKind>(p.at("kind").get<std::string>());
    if (!kind) throw IoError("metrics.json: " + p.at("kind").dump() + " is no kind of mark");
    PlacedMark mark{p.at("mark"), *kind, shape_index(p.at("shape"), names),
                    places_from(p.at("triangles"), p.at("weights"))};
    const std::size_t count = mark.places.size();
    const bool fits = *kind == MarkKind::point ? count == 1 : count >= 2;
    if (!fits || first.try_emplace(mark.mark, *kind, count).first->second != std::pair(*kind, count))
      throw IoError("metrics.json: the mark " + p.at("mark").dump() + " of " + p.at("shape").dump() +
                    " has " + std::to_string(count) +
                    " places, which do not fit its kind or its other shapes");
    placed.push_back(std::move(mark));
  }
  return placed;
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
      {"pairs", pairs},
      {"placed_definition",
       "the closest points of the shape's corresponding mesh to a point and to 20 evenly spaced ones of a "
       "curve: triangles of the landmarks, and the weights of the first two corners of each in units of "
       "1/10000, of which the three corners have 10000 together"},
      {"placed", placed_json(marks.placed, names)}};
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
  if (j.contains("placed")) marks.placed = placed_from(j.at("placed"), names);
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
