#pragma once
// Texts of positions and lengths in messages.

#include <string>

#include "foramen/core/mesh.hpp"

namespace foramen::repair_detail {

/// "(1.2, -3.4, 5.6)": millimetres, one digit.
std::string shown(const Vec3& position);
/// "2.3 mm".
std::string shown_mm(double length);

}  // namespace foramen::repair_detail
