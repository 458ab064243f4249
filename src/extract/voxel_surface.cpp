#include "extract/voxel_surface.hpp"

#include <string>

#include "extract/cube_triangles.hpp"
#include "foramen/core/error.hpp"

namespace foramen::extract {
namespace {

constexpr std::size_t most_vertices = 20000000;

// Indices of the vertices on the lattice edges that leave a voxel in positive directions. Two successive
// layers of voxels are kept, since a layer of cubes needs no others.
class EdgeVertices {
 public:
  explicit EdgeVertices(const BinaryVolume& volume)
      : width_(volume.size[0]), vertices_(6 * volume.index(0, 0, 1), none) {}
  static constexpr int none = -1;
  int& at(int axis, int i, int j, int layer) {
    return vertices_[(static_cast<std::size_t>(axis) * 2 + static_cast<std::size_t>(layer % 2)) *
                         (vertices_.size() / 6) +
                     static_cast<std::size_t>(j) * static_cast<std::size_t>(width_) +
                     static_cast<std::size_t>(i)];
  }

 private:
  int width_;
  std::vector<int> vertices_;
};

// Adds the vertices on the lattice edges that leave the voxels of layer k in positive directions.
void add_vertices(const BinaryVolume& volume, int k, EdgeVertices& edges, std::vector<Vec3>& points) {
  for (int j = 0; j < volume.size[1]; ++j)
    for (int i = 0; i < volume.size[0]; ++i)
      for (int axis = 0; axis < 3; ++axis) {
        int& vertex = edges.at(axis, i, j, k);
        vertex = EdgeVertices::none;
        std::array<int, 3> to{i, j, k};
        if (++to[axis] >= volume.size[axis]) continue;
        if (volume.at(i, j, k) == volume.at(to[0], to[1], to[2])) continue;
        vertex = static_cast<int>(points.size());
        points.emplace_back(i, j, k);
        points.back()[axis] += 0.5;
      }
}

}  // namespace

TriangleSoup voxel_surface(const BinaryVolume& volume, EdgeContact contact) {
  TriangleSoup soup;
  EdgeVertices edges(volume);
  add_vertices(volume, 0, edges, soup.points);
  for (int k = 0; k + 1 < volume.size[2]; ++k) {
    add_vertices(volume, k + 1, edges, soup.points);
    if (soup.points.size() > most_vertices)
      throw InvalidInput("its surface has more than " + std::to_string(most_vertices) +
                         " vertices: this is no vertebra; give a label map, in which a label is one thing");
    for (int j = 0; j + 1 < volume.size[1]; ++j)
      for (int i = 0; i + 1 < volume.size[0]; ++i) {
        unsigned inside = 0;
        for (int c = 0; c < 8; ++c)
          if (volume.at(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2 & 1))) inside |= 1U << c;
        for (const auto& t : cube_triangles(inside, contact)) {
          std::array<int, 3> corners{};
          for (std::size_t m = 0; m < 3; ++m) {
            const CubeEdge e = cube_edge(t[m]);
            corners[m] = edges.at(e.axis, i + e.from[0], j + e.from[1], k + e.from[2]);
          }
          soup.triangles.push_back(corners);
        }
      }
  }
  return soup;
}

TriangleSoup voxel_boundary(const BinaryVolume& volume) {
  TriangleSoup soup;
  for (int k = 0; k < volume.size[2]; ++k)
    for (int j = 0; j < volume.size[1]; ++j)
      for (int i = 0; i < volume.size[0]; ++i)
        for (int axis = 0; axis < 3; ++axis) {
          std::array<int, 3> to{i, j, k};
          if (++to[axis] >= volume.size[axis]) continue;
          const bool inside = volume.at(i, j, k);
          if (inside == volume.at(to[0], to[1], to[2])) continue;
          const Vec3 middle = Vec3(i, j, k) + 0.5 * Vec3::Unit(axis);
          const Vec3 u = 0.5 * Vec3::Unit((axis + 1) % 3), v = 0.5 * Vec3::Unit((axis + 2) % 3);
          const int first = static_cast<int>(soup.points.size());
          for (const Vec3& corner : {Vec3(-u - v), Vec3(u - v), Vec3(u + v), Vec3(v - u)})
            soup.points.push_back(middle + corner);
          const int second = first + (inside ? 1 : 3), last = first + (inside ? 3 : 1);
          soup.triangles.push_back({first, second, first + 2});
          soup.triangles.push_back({first, first + 2, last});
        }
  return soup;
}

}  // namespace foramen::extract
