#pragma once
/// \file
/// What people marked on shapes: named points and curves, and regions of the surface.

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "foramen/core/mesh.hpp"
#include "foramen/core/options.hpp"

namespace foramen {

enum class MarkKind {
  point,        ///< one point
  open_curve,   ///< a polyline of at least 2 points, from its start to its end
  closed_curve  ///< a ring of at least 3 points; the last is joined to the first
};
template <>
struct EnumWords<MarkKind> {
  static constexpr std::pair<std::string_view, MarkKind> all[] = {
      {"point", MarkKind::point}, {"open", MarkKind::open_curve}, {"closed", MarkKind::closed_curve}};
};

/// A point or curve that someone marked on a shape. Marks of the same name correspond.
struct Mark {
  std::string name;
  MarkKind kind = MarkKind::point;
  std::vector<Vec3> points;  ///< in the coordinates of the shape's input, mm
};

/// The marks of one shape, each name once.
using MarksOfShape = std::vector<Mark>;

/// Regions of the input surface of one shape. Regions of the same name correspond.
struct RegionsOfShape {
  std::vector<std::string> names;
  std::vector<int> of_vertex;  ///< index of the region's name for each vertex of the input; -1: in no region
};

/// The regions of labels, one per vertex. A region's name is its label; 0 and less is no region.
RegionsOfShape regions_of_labels(std::span<const int> labels);

}  // namespace foramen
