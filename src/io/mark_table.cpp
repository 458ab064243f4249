// Marks as a table: one row a point.
#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>

#include "foramen/core/error.hpp"
#include "io/mark_formats.hpp"
#include "io/table_file.hpp"

namespace foramen::io_detail {
namespace {

std::optional<std::size_t> column_if_there(const Table& table, const char* name) {
  const auto found = std::find(table.header.begin(), table.header.end(), name);
  if (found == table.header.end()) return std::nullopt;
  return static_cast<std::size_t>(found - table.header.begin());
}

// The points of a mark by their index.
struct IndexedMark {
  Mark mark;
  std::vector<std::pair<std::int64_t, Vec3>> points = {};
};

class MarkTable {
 public:
  explicit MarkTable(const Table& table)
      : landmark_(table.column("landmark")),
        axes_{table.column("x"), table.column("y"), table.column("z")},
        shape_(column_if_there(table, "shape")),
        kind_(column_if_there(table, "kind")),
        index_(column_if_there(table, "index")) {}

  void add(const std::vector<std::string>& row) {
    const std::string shape = shape_ ? row[*shape_] : "";
    const std::string& name = row[landmark_];
    if (name.empty()) throw IoError("it has no landmark; name it");
    const MarkKind kind = kind_ ? kind_of(row[*kind_]) : MarkKind::point;
    auto& marks = of_shape(shape);
    auto mark = std::find_if(marks.begin(), marks.end(), [&](const auto& m) { return m.mark.name == name; });
    if (mark == marks.end()) mark = marks.insert(mark, IndexedMark{{name, kind, {}}, {}});
    if (mark->mark.kind != kind)
      throw IoError("the mark " + in_quotes(name) + " has rows of two kinds; give all of them the same");
    Vec3 point;
    for (std::size_t k = 0; k < axes_.size(); ++k) point[static_cast<int>(k)] = parse_number(row[axes_[k]]);
    const auto index = index_ ? to_integer(row[*index_]) : static_cast<std::int64_t>(mark->points.size());
    if (!index) throw IoError("expected an index, found " + in_quotes(row[*index_]) + "; correct it");
    for (const auto& [taken, other] : mark->points)
      if (taken == *index)
        throw IoError("the mark " + in_quotes(name) + " has two points of the index " +
                      std::to_string(taken) + "; number them");
    mark->points.emplace_back(*index, point);
  }

  MarkFile file() && {
    MarkFile file;
    for (auto& [shape, marks] : shapes_) {
      NamedMarks named{shape, {}};
      for (IndexedMark& indexed : marks) {
        std::sort(indexed.points.begin(), indexed.points.end(),
                  [](const auto& a, const auto& b) { return a.first < b.first; });
        for (const auto& [index, point] : indexed.points) indexed.mark.points.push_back(point);
        named.marks.push_back(std::move(indexed.mark));
      }
      file.shapes.push_back(std::move(named));
    }
    return file;
  }

 private:
  static MarkKind kind_of(const std::string& word) {
    const auto kind = value_of<MarkKind>(lower_case(word));
    if (!kind)
      throw IoError("expected the kind point, open or closed, found " + in_quotes(word) + "; correct it");
    return *kind;
  }
  std::vector<IndexedMark>& of_shape(const std::string& shape) {
    const auto found =
        std::find_if(shapes_.begin(), shapes_.end(), [&](const auto& s) { return s.first == shape; });
    return found != shapes_.end() ? found->second
                                  : shapes_.emplace_back(shape, std::vector<IndexedMark>()).second;
  }

  std::size_t landmark_;
  std::array<std::size_t, 3> axes_;
  std::optional<std::size_t> shape_, kind_, index_;
  std::vector<std::pair<std::string, std::vector<IndexedMark>>> shapes_;
};

}  // namespace

MarkFile read_mark_table(const std::filesystem::path& path) {
  const Table table = read_csv(path);
  const Source source{path.string(), {}};
  if (table.rows.empty()) source.refuse("has no rows", "leave it out");
  std::string place;
  try {
    MarkTable marks(table);
    for (std::size_t r = 0; r < table.rows.size(); ++r) {
      place = "row " + std::to_string(r + 1) + ": ";
      marks.add(table.rows[r]);
    }
    return std::move(marks).file();
  } catch (const IoError& e) {
    throw IoError(path.string() + ": " + place + e.what());
  }
}

}  // namespace foramen::io_detail
