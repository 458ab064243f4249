// Markups of 3D Slicer: .mrk.json (schema 1.0) and .fcsv.
#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "io/mark_formats.hpp"

namespace foramen::io_detail {
namespace {

using nlohmann::ordered_json;

constexpr const char* remedy_save = "save the markups again";

struct ControlPoint {
  std::string label;
  Vec3 position = Vec3::Zero();
};

std::string text_of(const ordered_json& object, const char* name) {
  const auto found = object.find(name);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

// How a type of markup is marked on the shape; nullopt for those that are no points or curves.
std::optional<MarkKind> kind_of(const std::string& type) {
  if (type == "Fiducial" || type == "Angle") return MarkKind::point;
  if (type == "Curve" || type == "Line") return MarkKind::open_curve;
  if (type == "ClosedCurve") return MarkKind::closed_curve;
  return std::nullopt;
}

std::vector<ControlPoint> placed_points(const Source& source, const ordered_json& markup,
                                        const std::string& place) {
  const auto list = markup.find("controlPoints");
  if (list == markup.end() || !list->is_array()) source.refuse(place + " has no controlPoints", remedy_save);
  std::vector<ControlPoint> points;
  std::size_t number = 0;
  for (const ordered_json& item : *list) {
    const std::string of_point = place + ", control point " + std::to_string(++number);
    if (!item.is_object()) source.refuse(of_point + " is no object", remedy_save);
    const std::string status = text_of(item, "positionStatus");
    if (!status.empty() && status != "defined") continue;
    ControlPoint point{text_of(item, "label"), {}};
    const auto position = item.find("position");
    const bool three = position != item.end() && position->is_array() && position->size() == 3;
    for (int k = 0; k < 3; ++k) {
      if (!three || !position->at(k).is_number())
        source.refuse(of_point + " has no position of three numbers", remedy_save);
      point.position[k] = position->at(k).get<double>();
    }
    points.push_back(std::move(point));
  }
  return points;
}

// "rim" of "rim-1", "rim-2", ...; empty if the labels have nothing in common.
std::string common_part(const std::vector<ControlPoint>& points) {
  std::optional<std::string> common;
  for (const ControlPoint& point : points) {
    const auto last = point.label.find_last_not_of("0123456789");
    if (last == std::string::npos) return {};
    std::string part = point.label.substr(0, last + 1);
    if (part.back() == '-' || part.back() == '_' || part.back() == ' ') part.pop_back();
    if (common && *common != part) return {};
    common = part;
  }
  return common.value_or("");
}

void check_millimetres(const Source& source, const ordered_json& markup, const std::string& place) {
  const auto units = markup.find("coordinateUnits");
  if (units == markup.end()) return;
  const ordered_json all = units->is_array() ? *units : ordered_json::array({*units});
  for (const ordered_json& unit : all)
    if (unit != "mm" && unit != "")
      source.refuse(place + " has coordinates in " + unit.dump(), "save it in mm");
}

void add_marks(const Source& source, MarkKind kind, const ordered_json& markup, const std::string& place,
               MarksOfShape& marks) {
  const std::vector<ControlPoint> points = placed_points(source, markup, place);
  if (kind == MarkKind::point) {
    for (const ControlPoint& point : points) {
      if (point.label.empty()) source.refuse(place + " has a point without a label", "label every point");
      marks.push_back({point.label, kind, {point.position}});
    }
    return;
  }
  if (points.empty()) return;
  const std::string own = text_of(markup, "name");
  Mark curve{own.empty() ? common_part(points) : own, kind, {}};
  for (const ControlPoint& point : points) curve.points.push_back(point.position);
  marks.push_back(std::move(curve));
}

struct FcsvColumns {
  std::size_t x = 1, y = 2, z = 3, label = 11;
};

std::vector<std::string> cells_of(std::string_view line) {
  std::vector<std::string> cells;
  for (;;) {
    const auto comma = line.find(',');
    cells.emplace_back(TokenCursor(line.substr(0, comma)).rest());
    if (comma == std::string_view::npos) return cells;
    line.remove_prefix(comma + 1);
  }
}

// The part after "# NAME = " in a line of the header; nullopt for another line.
std::optional<std::string_view> header_value(std::string_view line, std::string_view name) {
  TokenCursor words(line.substr(1));
  if (words.next() != name || words.next() != "=") return std::nullopt;
  return words.rest();
}

FcsvColumns columns_of(const Source& source, std::string_view names) {
  const std::vector<std::string> cells = cells_of(names);
  const auto column = [&](const char* name) {
    const auto found = std::find(cells.begin(), cells.end(), name);
    if (found == cells.end())
      source.refuse(std::string("has no column ") + name, "save the markups as .fcsv again");
    return static_cast<std::size_t>(found - cells.begin());
  };
  return {column("x"), column("y"), column("z"), column("label")};
}

}  // namespace

MarkFile parse_slicer_markups(const Source& source, const ordered_json& json) {
  MarkFile file{{{}}, {}};
  const ordered_json& markups = json.at("markups");
  if (!markups.is_array()) source.refuse("its 'markups' are no list", remedy_save);
  std::size_t number = 0;
  for (const ordered_json& markup : markups) {
    const std::string place = "markup " + std::to_string(++number);
    if (!markup.is_object()) source.refuse(place + " is no object", remedy_save);
    const std::string type = text_of(markup, "type");
    const auto kind = kind_of(type);
    if (!kind)
      source.refuse(place + " is of the type " + in_quotes(type) + ", which is no point and no curve",
                    "leave it out of the file");
    check_millimetres(source, markup, place);
    // Slicer's own default.
    const std::string system = text_of(markup, "coordinateSystem");
    const AnatomicalSpace space = space_named(source, system.empty() ? "LPS" : system);
    if (file.space && *file.space != space)
      source.refuse("its markups have different coordinate systems", "save them in one");
    file.space = space;
    add_marks(source, *kind, markup, place, file.shapes.front().marks);
  }
  if (file.shapes.front().marks.empty())
    source.refuse("holds no placed points", "place them, or leave it out");
  return file;
}

MarkFile parse_fcsv(const Source& source) {
  MarkFile file{{{}}, AnatomicalSpace::ras};  // old files do not name the space, which was RAS
  FcsvColumns columns;
  LineCursor lines(source.bytes);
  while (lines.next_filled()) {
    const std::string_view line = lines.line();
    if (line.starts_with('#')) {
      if (const auto space = header_value(line, "CoordinateSystem")) file.space = space_named(source, *space);
      if (const auto names = header_value(line, "columns")) columns = columns_of(source, *names);
      continue;
    }
    const std::vector<std::string> cells = cells_of(line);
    if (cells.size() <= std::max({columns.x, columns.y, columns.z, columns.label}))
      source.refuse(
          lines.place() + " has " + std::to_string(cells.size()) + " cells, and no label among them",
          "save the markups as .fcsv again");
    Mark mark{cells[columns.label], MarkKind::point, {Vec3::Zero()}};
    if (mark.name.empty()) source.refuse(lines.place() + " has no label", "label every point");
    int k = 0;
    for (const std::size_t column : {columns.x, columns.y, columns.z}) {
      const auto number = to_number(cells[column]);
      if (!number)
        source.refuse(lines.place() + ": expected a coordinate, found " + in_quotes(cells[column]),
                      "correct it");
      mark.points.front()[k++] = *number;
    }
    file.shapes.front().marks.push_back(std::move(mark));
  }
  if (file.shapes.front().marks.empty()) source.refuse("holds no points", "place them, or leave it out");
  return file;
}

}  // namespace foramen::io_detail
