// A program outside the project that uses the installed io module, which links most libraries: the calls
// below need expat, zlib, HDF5 and nlohmann-json.
#include <cstdio>
#include <foramen/core/error.hpp>
#include <foramen/io/mesh_file.hpp>
#include <foramen/io/statismo_file.hpp>

int main() {
  const foramen::TriangleSoup triangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  foramen::write_vtp("triangle.vtp", triangle);
  const std::size_t points = foramen::read_mesh("triangle.vtp").soup.points.size();
  try {
    foramen::read_statismo("no_such_model.h5");
  } catch (const foramen::IoError& error) {
    std::printf("%zu points; %s\n", points, error.what());
    return points == 3 ? 0 : 1;
  }
  return 1;
}
