// Meshes made in memory, brought into correspondence: tubes bent to a ring, each with a bump of another
// height.
#include <cmath>
#include <cstdio>
#include <numbers>

#include <foramen/foramen.hpp>

// A ring of 40 mm diameter whose tube is thicker by `bump` mm in one place.
foramen::Mesh ring(double bump, int around, int across) {
  Eigen::MatrixX3d points(around * across, 3);
  Eigen::MatrixX3i triangles(2 * around * across, 3);
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const double u = 2 * std::numbers::pi * i / around, v = 2 * std::numbers::pi * j / across;
      const double tube =
          8 + 2 * std::cos(v) + bump * std::exp(4 * (std::cos(u) - 1)) * (1 + 0.3 * std::sin(v));
      const double radius = 20 + tube * std::cos(v);
      points.row(i * across + j) << radius * std::cos(u), 1.3 * radius * std::sin(u), tube * std::sin(v);
      const int right = (i + 1) % around, up = (j + 1) % across;
      const int corner = i * across + j, beside = right * across + j, above = i * across + up;
      triangles.row(2 * corner) << corner, beside, right * across + up;
      triangles.row(2 * corner + 1) << corner, right * across + up, above;
    }
  return foramen::mesh_from_matrices(points, triangles);
}

int main() {
  std::vector<foramen::Shape> shapes;
  for (int k = 0; k < 4; ++k) shapes.push_back({"ring" + std::to_string(k), ring(k, 44 + 2 * k, 24)});

  const foramen::RunContext ctx;
  foramen::Correspondence found = foramen::correspond(shapes, {}, ctx);
  for (const foramen::ShapeRegistration& shape : found.registration.shapes)
    std::printf("%s: %d of %d triangles of its map are flipped\n", shape.name.c_str(),
                shape.certificate.flipped, shape.certificate.triangles);

  const foramen::Landmarks landmarks = foramen::place_landmarks(
      shapes, std::move(found), {.count = 600, .spread = {.grid_points = 8000}}, ctx);
  const Eigen::MatrixX3d on_first = foramen::matrix_of(landmarks.points[0]);
  std::printf("%d landmarks; the first lies at (%.2f, %.2f, %.2f) mm on %s\n",
              static_cast<int>(on_first.rows()), on_first(0, 0), on_first(0, 1), on_first(0, 2),
              landmarks.names[0].c_str());
  return landmarks.remaining_flips == 0 ? 0 : 1;
}
