#include "match/principal_frame.hpp"

#include <algorithm>
#include <array>

#include <Eigen/Eigenvalues>

namespace foramen::detail {

PrincipalFrame principal_frame(const Mesh& mesh) {
  const Vec3 centre = surface_centroid(mesh);
  Mat3 moments = Mat3::Zero();
  for (FaceId f : mesh.faces()) {
    // Exact over a triangle: area / 12 (sum of p p^T over the corners + s s^T), s the sum of the corners.
    const auto t = mesh.triangle(f);
    const Vec3 s = t[0] + t[1] + t[2] - 3 * centre;
    Mat3 outer = s * s.transpose();
    for (const Vec3& p : t) outer += (p - centre) * (p - centre).transpose();
    moments += area(t) / 12 * outer;
  }
  PrincipalFrame frame{centre, Eigen::SelfAdjointEigenSolver<Mat3>(moments).eigenvectors()};
  if (frame.axes.determinant() < 0) frame.axes.col(0) *= -1;
  return frame;
}

std::vector<Mat3> proper_matchings() {
  std::vector<Mat3> rotations;
  std::array<int, 3> order{0, 1, 2};
  do {
    for (int signs = 0; signs < 8; ++signs) {
      Mat3 m = Mat3::Zero();
      for (int k = 0; k < 3; ++k) m(order[k], k) = (signs >> k) % 2 == 0 ? 1 : -1;
      if (m.determinant() > 0) rotations.push_back(m);
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return rotations;
}

}  // namespace foramen::detail
