#include "foramen/core/shape.hpp"

#include <algorithm>

#include "foramen/core/error.hpp"

namespace foramen {

const Shape& shape_named(std::span<const Shape> shapes, const std::string& name) {
  const auto found =
      std::find_if(shapes.begin(), shapes.end(), [&](const Shape& s) { return s.name == name; });
  if (found == shapes.end()) throw InvalidInput("there is no shape of the name " + name);
  return *found;
}

}  // namespace foramen
