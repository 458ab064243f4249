#include "repair/words.hpp"

#include <cstdio>

namespace foramen::repair_detail {

std::string shown(const Vec3& position) {
  char text[128];
  std::snprintf(text, sizeof text, "(%.1f, %.1f, %.1f)", position.x(), position.y(), position.z());
  return text;
}

std::string shown_mm(double length) {
  char text[64];
  std::snprintf(text, sizeof text, "%.1f mm", length);
  return text;
}

}  // namespace foramen::repair_detail
