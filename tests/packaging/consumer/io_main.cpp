// The same for the module that links most: what is called here needs expat, zlib, HDF5 and libmd.
#include <cstdio>

#include "foramen/io/hdf5_file.hpp"
#include "foramen/io/mesh_file.hpp"
#include "foramen/io/sha256.hpp"

int main() {
  const foramen::TriangleSoup triangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  foramen::write_vtp("triangle.vtp", triangle);
  const std::size_t points = foramen::read_mesh("triangle.vtp").soup.points.size();
  foramen::write_h5("points.h5", [&](foramen::H5Writer& file) { file.scalar("/points", double(points)); });
  const std::string name = foramen::sha256_of_file("points.h5");
  std::printf("%zu points, sha256 %s\n", points, name.c_str());
  return points == 3 && name.size() == 64 ? 0 : 1;
}
