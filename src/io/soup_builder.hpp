#pragma once
/// \file
/// Private to io: collects the surface that a reader finds in a file.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "foramen/io/mesh_file.hpp"
#include "io/file_bytes.hpp"

namespace foramen::io_detail {

/// Collects points and faces and checks each of them. Polygons and strips become triangles, and one note of
/// the finished file says what was changed or passed over. `place` returns the position in the file for error
/// messages, e.g. "line 7".
class SoupBuilder {
 public:
  explicit SoupBuilder(const Source& source) : source_(source) {}
  /// Reserves memory for the numbers that a header states. Refuses numbers that do not fit the ids or for
  /// which the file is too small. `bytes_left` is the size of the data after the header; `point_bytes` and
  /// `triangle_bytes` are the least sizes of one point and one triangle.
  void expect(std::uint64_t points, std::uint64_t triangles, std::uint64_t bytes_left,
              std::uint64_t point_bytes, std::uint64_t triangle_bytes);
  template <class Place>
  void add_point(const Vec3& p, const Place& place) {
    if (!p.allFinite()) refuse_point(place());
    soup_.points.push_back(p);
  }
  /// A face of any number of corners; one of fewer than three is passed over. Refuses a corner that is not an
  /// index of one of `point_count` points, all of which may still follow.
  template <class Place>
  void add_face(std::span<const std::int64_t> corners, std::uint64_t point_count, const Place& place) {
    check_corners(corners, point_count, place);
    if (corners.size() == 3)
      add_checked({corners[0], corners[1], corners[2]});
    else if (corners.size() < 3)
      ++loose_;
    else
      add_polygon(corners, place());
  }
  /// Triangles that each share an edge with the one before. Those with a corner twice, by which strips are
  /// joined, are left out.
  template <class Place>
  void add_strip(std::span<const std::int64_t> corners, std::uint64_t point_count, const Place& place) {
    check_corners(corners, point_count, place);
    ++strips_;
    for (std::size_t i = 0; i + 2 < corners.size(); ++i) {
      const std::int64_t a = corners[i], b = corners[i + 1], c = corners[i + 2];
      if (a == b || b == c || c == a) continue;
      if (i % 2 == 0)
        add_checked({a, b, c});
      else
        add_checked({b, a, c});
    }
  }
  /// Points and lines beside the faces. The finished surface has no points that only they use.
  void pass_over_loose(std::uint64_t count) { loose_ += count; }
  /// The finished surface has no points that no face uses.
  void pass_over_unused_points() { passes_over_unused_ = true; }
  /// Data after the last element.
  void pass_over_trailing(std::uint64_t bytes) { trailing_ += bytes; }
  std::size_t points() const { return soup_.points.size(); }
  std::size_t triangles() const { return soup_.triangles.size(); }
  /// \param written  the index as it stands in the file
  [[noreturn]] void refuse_corner(std::int64_t written, std::uint64_t point_count,
                                  const std::string& place) const;
  /// Returns the surface with its notes; refuses one without triangles.
  MeshFile finish(std::optional<AnatomicalSpace> space);

 private:
  struct Polygon {
    std::size_t triangles_before;       // in soup_
    std::size_t first_corner, corners;  // in polygon_corners_
  };

  template <class Place>
  void check_corners(std::span<const std::int64_t> corners, std::uint64_t point_count,
                     const Place& place) const {
    for (const std::int64_t corner : corners)
      if (corner < 0 || static_cast<std::uint64_t>(corner) >= point_count)
        refuse_corner(corner, point_count, place());
  }
  void add_checked(const std::array<std::int64_t, 3>& t) {
    soup_.triangles.push_back({static_cast<int>(t[0]), static_cast<int>(t[1]), static_cast<int>(t[2])});
  }
  void add_polygon(std::span<const std::int64_t> corners, const std::string& place);
  void triangulate();
  void remove_unused_points();
  std::string note() const;
  [[noreturn]] void refuse_point(const std::string& place) const;

  const Source& source_;
  TriangleSoup soup_;
  std::vector<Polygon> polygons_;
  std::vector<int> polygon_corners_;
  std::uint64_t strips_ = 0, loose_ = 0, trailing_ = 0, unused_ = 0;
  bool passes_over_unused_ = false;
};

}  // namespace foramen::io_detail
