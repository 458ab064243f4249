#include "match/vertex_matches.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "match/robust_weight.hpp"

namespace foramen {

double match_cut(std::span<const VertexMatch> matches, const MatchOptions& options) {
  std::vector<double> distances;
  distances.reserve(matches.size());
  for (const VertexMatch& m : matches) distances.push_back(m.distance);
  return options.rejection * std::max(upper_median(std::move(distances)), options.least_median_mm);
}

Mat3 match_precision(const VertexMatch& match, const OrientedPoint& at_vertex, const MatchScale& scale,
                     const MatchOptions& options) {
  const double ratio = match.distance / scale.cut_mm;
  const double weight = tukey_weight(ratio * ratio) * match.area_mm2 / options.independent_area_mm2 /
                        (2 * scale.noise_mm * scale.noise_mm);
  const Vec3 normal = mean_normal(at_vertex.normal, match.partner.normal);
  const double share = std::min(
      1.0, options.tangential_share + options.curved_share * at_vertex.curvedness * match.partner.curvedness);
  return weight * ((1 - share) * normal * normal.transpose() + share * Mat3::Identity());
}

}  // namespace foramen
