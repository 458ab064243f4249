// A program outside the project that uses the installed package.
#include <cstdio>

#include "foramen/model/shape_model.hpp"

int main() {
  using foramen::Vec3;
  const std::vector<std::vector<Vec3>> shapes{{Vec3(0, 0, 0), Vec3(1, 0, 0)}, {Vec3(0, 0, 0), Vec3(3, 0, 0)}};
  const auto model = foramen::model_of_aligned(shapes, {});
  std::printf("%d mode, variance %g\n", model.modes(), model.variance()[0]);
  return model.modes() == 1 ? 0 : 1;
}
