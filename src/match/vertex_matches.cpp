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

Mat3 match_precision(const VertexMatch& match, const Vec3& vertex_normal, const MatchScale& scale,
                     const MatchOptions& options) {
  const double ratio = match.distance / scale.cut_mm;
  const double weight = tukey_weight(ratio * ratio) * match.area_mm2 / options.independent_area_mm2 /
                        (2 * scale.noise_mm * scale.noise_mm);
  const Vec3 normal = mean_normal(vertex_normal, match.partner.normal);
  return weight * ((1 - options.tangential_share) * normal * normal.transpose() +
                   options.tangential_share * Mat3::Identity());
}

}  // namespace foramen
