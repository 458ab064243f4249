#include <array>

#include "foramen/core/error.hpp"
#include "io/named_points_text.hpp"
#include "io/table_file.hpp"

namespace foramen {

void write_landmark_table(const std::filesystem::path& path, std::span<const NamedPoints> shapes) {
  io_detail::check_specimens(path, shapes);
  std::vector<Row> rows;
  rows.reserve(shapes.size() * shapes.front().points.size());
  for (const NamedPoints& shape : shapes)
    for (std::size_t i = 0; i < shape.points.size(); ++i) {
      const Vec3& p = shape.points[i];
      rows.push_back({shape.name, static_cast<std::int64_t>(i), p.x(), p.y(), p.z()});
    }
  write_csv(path, {"shape", "landmark", "x", "y", "z"}, rows);
}

std::vector<NamedPoints> read_landmark_table(const std::filesystem::path& path) {
  const io_detail::Source source{path.string(), {}};
  const Table table = read_csv(path);
  std::vector<NamedPoints> shapes;
  try {
    const std::size_t shape = table.column("shape"), landmark = table.column("landmark");
    const std::array axes{table.column("x"), table.column("y"), table.column("z")};
    for (std::size_t r = 0; r < table.rows.size(); ++r) {
      const auto& row = table.rows[r];
      if (shapes.empty() || shapes.back().name != row[shape]) shapes.push_back({row[shape], {}});
      if (row[landmark] != std::to_string(shapes.back().points.size()))
        throw IoError("row " + std::to_string(r + 1) + ": expected landmark " +
                      std::to_string(shapes.back().points.size()) + ", found " +
                      io_detail::in_quotes(row[landmark]) + "; sort the rows by shape, then landmark");
      Vec3 point;
      for (std::size_t k = 0; k < axes.size(); ++k) point[static_cast<int>(k)] = parse_number(row[axes[k]]);
      if (!point.allFinite())
        throw IoError("row " + std::to_string(r + 1) + ": a coordinate is not finite; correct it");
      shapes.back().points.push_back(point);
    }
  } catch (const IoError& e) {
    throw IoError(path.string() + ": " + e.what());
  }
  io_detail::check_read(source, shapes);
  return shapes;
}

}  // namespace foramen
