#include "modelfiles/atlas_file.hpp"

#include <algorithm>
#include <utility>

#include "foramen/core/error.hpp"
#include "io/hdf5_file.hpp"

namespace foramen {
namespace {

// A matrix with a row for each item. An item is an Eigen vector or an array of `columns` numbers.
template <class Number, class Items>
H5Matrix<Number> rows_of(const Items& items, std::size_t columns) {
  H5Matrix<Number> matrix{items.size(), columns, {}};
  for (const auto& item : items)
    matrix.values.insert(matrix.values.end(), item.data(), item.data() + columns);
  return matrix;
}

template <class Item, class Number>
std::vector<Item> items_of(const H5Reader& file, const std::string& path, std::size_t columns) {
  const H5Matrix<Number> matrix = file.matrix<Number>(path);
  if (matrix.cols != columns)
    file.refuse(path, std::to_string(matrix.cols) + " columns, not " + std::to_string(columns));
  std::vector<Item> items(matrix.rows);
  for (std::size_t i = 0; i < matrix.rows; ++i)
    for (std::size_t c = 0; c < columns; ++c) items[i][static_cast<int>(c)] = matrix.values[i * columns + c];
  return items;
}

std::vector<std::array<int, 3>> triangles_of(const H5Reader& file, const std::string& path) {
  std::vector<std::array<int, 3>> triangles;
  for (const Eigen::Vector3i& t : items_of<Eigen::Vector3i, std::int32_t>(file, path, 3))
    triangles.push_back({t[0], t[1], t[2]});
  return triangles;
}

void require_count(const H5Reader& file, const std::string& path, std::size_t found, std::size_t expected) {
  if (found != expected) file.refuse(path, std::to_string(found) + " rows, not " + std::to_string(expected));
}

void require_walk(const H5Reader& file, const Mesh& surface, const std::vector<VertexId>& loop) {
  for (std::size_t i = 0; i < loop.size(); ++i)
    if (!surface.find_halfedge(loop[i], loop[(i + 1) % loop.size()]).valid())
      file.refuse("/loops", "step " + std::to_string(i) + " is no edge of the template");
}

Atlas read_from(const H5Reader& file) {
  Atlas atlas;
  atlas.surface = build_mesh(
      {items_of<Vec3, double>(file, "/template/points", 3), triangles_of(file, "/template/triangles")});
  if (!atlas.surface.is_closed()) file.refuse("/template/triangles", "not a closed surface");
  atlas.map.turns = VertexMap<Vec2>(items_of<Vec2, double>(file, "/template/turns", 2));
  require_count(file, "/template/turns", atlas.map.turns.size(),
                static_cast<std::size_t>(atlas.surface.vertex_count()));
  atlas.map.jumps = HalfedgeMap<Vec2i>(items_of<Vec2i, std::int32_t>(file, "/template/jumps", 2));
  require_count(file, "/template/jumps", atlas.map.jumps.size(),
                static_cast<std::size_t>(atlas.surface.halfedge_count()));
  const Eigen::MatrixXd lattice = eigen_matrix(file.matrix<double>("/lattice"));
  if (lattice.rows() != 2 || lattice.cols() != 2) file.refuse("/lattice", "not a 2 x 2 matrix");
  atlas.map.lattice = lattice;
  for (std::size_t k = 0; k < 2; ++k)
    for (std::int32_t v : file.vector<std::int32_t>("/loops/" + std::to_string(k))) {
      if (v < 0 || v >= atlas.surface.vertex_count()) file.refuse("/loops", "vertex " + std::to_string(v));
      atlas.loops[k].emplace_back(v);
    }
  for (const auto& loop : atlas.loops) require_walk(file, atlas.surface, loop);
  atlas.landmarks.turns = items_of<Vec2, double>(file, "/landmarks/turns", 2);
  atlas.landmarks.triangles = triangles_of(file, "/landmarks/triangles");
  atlas.landmarks.jumps = HalfedgeMap<Vec2i>(items_of<Vec2i, std::int32_t>(file, "/landmarks/jumps", 2));
  if (const std::string path = "/landmarks/curvatures"; file.has(path)) {
    atlas.curvatures = items_of<Vec2, double>(file, path, 2);
    require_count(file, path, atlas.curvatures.size(), atlas.landmarks.turns.size());
  }
  atlas.names = file.children("/shapes");
  for (const std::string& name : atlas.names) {
    const Eigen::MatrixXd transform = eigen_matrix(file.matrix<double>("/shapes/" + name + "/transform"));
    if (transform.rows() != 4 || transform.cols() != 4) file.refuse("/shapes/" + name, "not a 4 x 4 matrix");
    atlas.transforms.emplace_back(transform);
  }
  return atlas;
}

}  // namespace

void write_atlas(const std::filesystem::path& path, const Atlas& atlas) {
  write_h5(path, [&](H5Writer& file) {
    file.matrix<double>("/template/points", rows_of<double>(atlas.surface.positions(), 3));
    file.matrix<std::int32_t>("/template/triangles", rows_of<std::int32_t>(atlas.surface.triangles(), 3));
    file.matrix<double>("/template/turns", rows_of<double>(atlas.map.turns.values(), 2));
    file.matrix<std::int32_t>("/template/jumps", rows_of<std::int32_t>(atlas.map.jumps.values(), 2));
    file.matrix<double>("/lattice", h5_matrix(atlas.map.lattice));
    for (std::size_t k = 0; k < 2; ++k) {
      std::vector<std::int32_t> vertices;
      for (VertexId v : atlas.loops[k]) vertices.push_back(v.index);
      file.vector<std::int32_t>("/loops/" + std::to_string(k), vertices);
    }
    file.matrix<std::int32_t>("/loops/periods", {2, 2, {1, 0, 0, 1}});
    file.matrix<double>("/landmarks/turns", rows_of<double>(atlas.landmarks.turns, 2));
    file.matrix<std::int32_t>("/landmarks/triangles", rows_of<std::int32_t>(atlas.landmarks.triangles, 3));
    file.matrix<std::int32_t>("/landmarks/jumps", rows_of<std::int32_t>(atlas.landmarks.jumps.values(), 2));
    if (!atlas.curvatures.empty())
      file.matrix<double>("/landmarks/curvatures", rows_of<double>(atlas.curvatures, 2));
    for (std::size_t i = 0; i < atlas.names.size(); ++i)
      file.matrix<double>("/shapes/" + atlas.names[i] + "/transform", h5_matrix(atlas.transforms[i]));
  });
}

Atlas read_atlas(const std::filesystem::path& path) { return read_h5(path, read_from); }

}  // namespace foramen
