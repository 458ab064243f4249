#include "pages/report_data.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "foramen/core/error.hpp"
#include "foramen/evaluate/representation.hpp"
#include "modelfiles/version.hpp"
#include "pages/page_loops.hpp"
#include "report/encoded_array.hpp"

namespace foramen {
namespace {

using nlohmann::ordered_json;

constexpr int format_version = 1;
// Further modes move the shape little and would make the page large.
constexpr int most_modes = 60;
constexpr double error_unit_mm = 0.001;

template <class T>
ordered_json array_json(const std::vector<T>& values, std::vector<std::size_t> shape) {
  const EncodedArray array = encoded(std::span<const T>(values), std::move(shape));
  return {{"type", array.type}, {"shape", array.shape}, {"base64", array.base64}};
}

template <class Derived>
std::vector<float> floats(const Eigen::DenseBase<Derived>& values) {
  std::vector<float> out;
  out.reserve(values.size());
  for (Eigen::Index i = 0; i < values.size(); ++i) out.push_back(static_cast<float>(values(i)));
  return out;
}

ordered_json vector_json(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

ordered_json indices_json(const std::vector<int>& values) {
  return array_json(std::vector<std::uint32_t>(values.begin(), values.end()), {values.size()});
}

ordered_json triangles_json(const std::vector<std::array<int, 3>>& triangles) {
  std::vector<std::uint32_t> corners;
  for (const auto& t : triangles) corners.insert(corners.end(), t.begin(), t.end());
  return array_json(corners, {triangles.size(), 3});
}

int page_modes(const ShapeModel& model) { return std::min(model.modes(), most_modes); }

ordered_json model_json(const ModelRecord& record) {
  const ShapeModel& model = record.loaded.model;
  const std::size_t landmarks = model.landmarks();
  const int modes = page_modes(model);
  std::vector<float> displacements;
  ordered_json shares = ordered_json::array();
  for (int m = 0; m < modes; ++m) {
    const std::vector<float> of_mode = floats(model.basis().col(m) * std::sqrt(model.variance()[m]));
    displacements.insert(displacements.end(), of_mode.begin(), of_mode.end());
    shares.push_back(model.variance()[m] / model.variance().sum());
  }
  return {{"space", record.loaded.space == AnatomicalSpace::lps ? "LPS" : "RAS"},
          {"modes_of_model", model.modes()},
          {"variance_shares", shares},
          {"mean", array_json(floats(model.mean()), {landmarks, 3})},
          {"modes", array_json(displacements, {static_cast<std::size_t>(modes), landmarks, 3})},
          {"triangles", triangles_json(model.triangles())}};
}

ordered_json torus_json(const Atlas& atlas) {
  std::vector<float> turns;
  for (const Vec2& p : atlas.landmarks.turns)
    for (double t : p) turns.push_back(static_cast<float>(t));
  std::vector<std::int8_t> jumps;
  for (const Vec2i& jump : atlas.landmarks.jumps.values())
    for (int t : jump) {
      if (t < std::numeric_limits<std::int8_t>::min() || t > std::numeric_limits<std::int8_t>::max())
        throw IoError("a landmark edge goes " + std::to_string(t) +
                      " times round the torus; the page holds up to 127");
      jumps.push_back(static_cast<std::int8_t>(t));
    }
  const Lattice& lattice = atlas.map.lattice;
  return {{"lattice", {{lattice(0, 0), lattice(0, 1)}, {lattice(1, 0), lattice(1, 1)}}},
          {"turns", array_json(turns, {atlas.landmarks.turns.size(), 2})},
          {"jumps", array_json(jumps, {jumps.size() / 2, 2})}};
}

ordered_json places_json(const std::vector<SurfacePoint>& places) {
  std::vector<std::uint32_t> triangles;
  std::vector<float> weights;
  for (const SurfacePoint& p : places) {
    triangles.push_back(static_cast<std::uint32_t>(p.face.index));
    for (double w : p.barycentric) weights.push_back(static_cast<float>(w));
  }
  return {{"triangles", array_json(triangles, {triangles.size()})},
          {"weights", array_json(weights, {triangles.size(), 3})}};
}

std::string hex(const Colour& colour) {
  constexpr const char* digits = "0123456789abcdef";
  std::string text = "#";
  for (const unsigned char channel : colour) text += {digits[channel / 16], digits[channel % 16]};
  return text;
}

ordered_json mark_json(const PageMark& mark) {
  std::vector<std::uint32_t> shapes;
  std::vector<SurfacePoint> places;
  for (const PlacedMark& placed : mark.scatter.placed) {
    shapes.push_back(static_cast<std::uint32_t>(placed.shape));
    places.insert(places.end(), placed.places.begin(), placed.places.end());
  }
  return {{"name", mark.scatter.mark},
          {"kind", word_of(mark.scatter.kind)},
          {"colour", hex(mark.colour)},
          {"scatter_mm", mark.scatter.rms},
          {"shapes", array_json(shapes, {shapes.size()})},
          {"places", places_json(places)}};
}

// Distances rounded to whole thousandths of a millimetre.
ordered_json errors_json(const std::vector<double>& landmark_mm) {
  std::vector<std::uint16_t> thousandths;
  constexpr double most = std::numeric_limits<std::uint16_t>::max();
  for (double mm : landmark_mm)
    thousandths.push_back(static_cast<std::uint16_t>(std::min(std::round(mm / error_unit_mm), most)));
  return array_json(thousandths, {thousandths.size()});
}

ordered_json shapes_json(const ModelRecord& record) {
  ordered_json shapes = ordered_json::array();
  const Evaluation& evaluation = record.evaluation;
  for (std::size_t i = 0; i < evaluation.names.size(); ++i) {
    const ShapeRepresentation& r = evaluation.representation.shapes[i];
    const ErrorMap& map = record.error_maps[i];
    const auto scores =
        floats(record.loaded.scores.col(static_cast<Eigen::Index>(i)).head(page_modes(record.loaded.model)));
    shapes.push_back(
        {{"name", evaluation.names[i]},
         {"subject", evaluation.subjects.empty() ? ordered_json() : ordered_json(evaluation.subjects[i])},
         {"is_reference", record.run.reference == evaluation.names[i]},
         {"scores", scores},
         {"error", errors_json(map.landmark_mm)},
         {"plain_flips", indices_json(map.plain_flips)},
         {"confirmed_flips", indices_json(map.confirmed_flips)},
         {"mean_mm", r.distance.mean},
         {"p95_mm", r.distance.p95},
         {"hausdorff_mm", r.distance.hausdorff}});
  }
  return shapes;
}

ordered_json views_json(const std::vector<PageView>& views) {
  ordered_json out = ordered_json::array();
  for (const PageView& view : views)
    out.push_back({{"name", view.name}, {"from", vector_json(view.from)}, {"up", vector_json(view.up)}});
  return out;
}

ordered_json chart_json(const Chart& chart) {
  ordered_json series = ordered_json::array();
  for (const ChartSeries& s : chart.series)
    series.push_back({{"name", s.name}, {"x", s.x}, {"y", s.y}, {"error", s.error}});
  return {{"title", chart.title}, {"x_label", chart.x_label}, {"y_label", chart.y_label}, {"series", series}};
}

ordered_json table_json(const ReportTable& table) {
  return {{"title", table.title}, {"note", table.note}, {"header", table.header}, {"rows", table.rows}};
}

template <class Items, class ToJson>
ordered_json list_json(const Items& items, const ToJson& to_json) {
  ordered_json out = ordered_json::array();
  for (const auto& item : items) out.push_back(to_json(item));
  return out;
}

}  // namespace

ordered_json report_data(const ModelRecord& record, const PageContents& contents) {
  const Mesh mean = build_mesh({unflattened(record.loaded.model.mean()), record.loaded.model.triangles()});
  const auto loops = loops_on_landmarks(record.atlas);
  return {{"format", "foramen-report"},
          {"format_version", format_version},
          {"foramen", version()},
          {"title", contents.title},
          {"subtitle", contents.subtitle},
          {"plain_words", list_json(contents.plain_words,
                                    [](const Statement& s) {
                                      return ordered_json{{"heading", s.heading}, {"text", s.text}};
                                    })},
          {"findings", contents.findings},
          {"model", model_json(record)},
          {"torus", torus_json(record.atlas)},
          {"loops", list_json(loops, places_json)},
          {"marks", list_json(contents.marks, mark_json)},
          {"views", views_json(page_views(mean, loops))},
          {"error_unit_mm", error_unit_mm},
          {"shapes", shapes_json(record)},
          {"charts", list_json(contents.charts, chart_json)},
          {"figures", list_json(contents.figures, table_json)},
          {"differences", list_json(contents.differences, table_json)},
          {"remarks", contents.remarks},
          {"shapes_table", table_json(contents.shapes)},
          {"left_out", table_json(contents.left_out)},
          {"repaired", table_json(contents.repaired)},
          {"refit_failures", table_json(contents.refit_failures)},
          {"made_by", contents.made_by},
          {"options", table_json(contents.options)},
          {"inputs", table_json(contents.inputs)},
          {"papers", table_json(contents.papers)}};
}

}  // namespace foramen
