#include "inputs/unused_points.hpp"

#include <algorithm>
#include <string>

#include "repair/used_points.hpp"

namespace foramen {

std::optional<Message> drop_unused_points(TriangleSoup& surface) {
  const auto points = std::ssize(surface.points);
  const auto exists = [&](int corner) { return corner >= 0 && corner < points; };
  const bool can_be_read =
      std::all_of(surface.triangles.begin(), surface.triangles.end(),
                  [&](const auto& t) { return exists(t[0]) && exists(t[1]) && exists(t[2]); });
  if (surface.triangles.empty() || !can_be_read) return std::nullopt;
  const auto dropped = points - std::ssize(repair_detail::keep_used_points(surface));
  if (dropped == 0) return std::nullopt;
  return Message(std::to_string(dropped) + (dropped == 1
                                                ? " point belongs to no triangle and was left out"
                                                : " points belong to no triangle and were left out"));
}

}  // namespace foramen
