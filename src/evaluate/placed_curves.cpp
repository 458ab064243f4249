#include "evaluate/placed_curves.hpp"

#include <algorithm>
#include <limits>

#include "foramen/core/error.hpp"

namespace foramen::detail {

std::vector<SurfacePoint> run_alike(const std::vector<SurfacePoint>& curve,
                                    const std::vector<SurfacePoint>& other, bool closed, const Mesh& mesh) {
  FORAMEN_ASSERT(curve.size() == other.size());
  std::vector<SurfacePoint> turned = curve, best = curve;
  double least = std::numeric_limits<double>::infinity();
  for (int direction = 0; direction < 2; ++direction) {
    for (std::size_t start = 0; start < (closed ? curve.size() : 1); ++start) {
      double squared = 0;
      for (std::size_t i = 0; i < turned.size(); ++i)
        squared += (position(mesh, turned[i]) - position(mesh, other[i])).squaredNorm();
      if (squared < least) {
        least = squared;
        best = turned;
      }
      if (closed) std::rotate(turned.begin(), turned.begin() + 1, turned.end());
    }
    std::reverse(turned.begin(), turned.end());
  }
  return best;
}

}  // namespace foramen::detail
