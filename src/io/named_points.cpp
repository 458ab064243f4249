#include "io/named_points_text.hpp"

#include <set>

#include "foramen/core/error.hpp"
#include "io/table_file.hpp"

namespace foramen::io_detail {

void check_specimens(const std::filesystem::path& path, std::span<const NamedPoints> specimens) {
  const auto expect = [&](bool condition, const std::string& otherwise) {
    if (!condition) throw InvalidInput("cannot write " + path.string() + ": " + otherwise);
  };
  expect(!specimens.empty() && !specimens.front().points.empty(), "there are no points");
  std::set<std::string> names;
  for (const NamedPoints& specimen : specimens) {
    expect(names.insert(specimen.name).second, "two shapes have the name " + in_quotes(specimen.name));
    expect(specimen.points.size() == specimens.front().points.size(),
           specimen.name + " has " + std::to_string(specimen.points.size()) + " points, " +
               specimens.front().name + " " + std::to_string(specimens.front().points.size()));
    for (const Vec3& point : specimen.points)
      expect(point.allFinite(), specimen.name + " has a coordinate that is not finite");
  }
}

void check_read(const Source& source, std::span<const NamedPoints> specimens) {
  if (specimens.empty()) source.refuse("holds no points", remedy_export_again);
  std::set<std::string> names;
  for (const NamedPoints& specimen : specimens) {
    if (!names.insert(specimen.name).second)
      source.refuse("two specimens have the name " + in_quotes(specimen.name), "rename one");
    if (specimen.points.size() != specimens.front().points.size())
      source.refuse(in_quotes(specimen.name) + " has " + std::to_string(specimen.points.size()) +
                        " points, " + in_quotes(specimens.front().name) + " " +
                        std::to_string(specimens.front().points.size()),
                    "corresponding points are as many on every specimen");
  }
}

std::string text_of(const Vec3& point) {
  return format_number(point.x()) + " " + format_number(point.y()) + " " + format_number(point.z());
}

std::optional<Vec3> point_of(std::string_view line) {
  TokenCursor words(line);
  Vec3 point;
  for (int k = 0; k < 3; ++k) {
    const auto number = to_number(words.next());
    if (!number) return std::nullopt;
    point[k] = *number;
  }
  if (!words.rest().empty() || !point.allFinite()) return std::nullopt;
  return point;
}

}  // namespace foramen::io_detail
