#include "evaluate/measured_surface.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/core/rng.hpp"
#include "foramen/spatial/surface_distance.hpp"

namespace foramen::detail {
namespace {

// A ball around a thousandth of the surface is small compared with Hausdorff distances between different
// shapes.
constexpr int cluster_count = 1000;

/// Divides the faces into groups by halving ranges along the widest axis of their centroids.
class FaceGroups {
 public:
  FaceGroups(const Mesh& mesh, int largest) : largest_(largest), order_(mesh.face_count()) {
    std::iota(order_.begin(), order_.end(), 0);
    for (FaceId f : mesh.faces()) {
      const auto t = mesh.triangle(f);
      centroids_.push_back((t[0] + t[1] + t[2]) / 3);
    }
    if (!order_.empty()) split(order_.begin(), order_.end());
  }
  std::vector<std::vector<int>> take() { return std::move(groups_); }

 private:
  using Iterator = std::vector<int>::iterator;
  const Vec3& centroid(int face) const { return centroids_[face]; }

  void split(Iterator first, Iterator last) {
    if (last - first <= largest_) {
      groups_.emplace_back(first, last);
      return;
    }
    Vec3 low = centroid(*first), high = low;
    for (auto f = first; f != last; ++f) {
      low = low.cwiseMin(centroid(*f));
      high = high.cwiseMax(centroid(*f));
    }
    Eigen::Index axis = 0;
    (high - low).maxCoeff(&axis);
    const auto middle = first + (last - first) / 2;
    std::nth_element(first, middle, last, [&](int a, int b) {
      return std::pair(centroid(a)[axis], a) < std::pair(centroid(b)[axis], b);
    });
    split(first, middle);
    split(middle, last);
  }

  std::ptrdiff_t largest_;
  std::vector<int> order_;
  std::vector<Vec3> centroids_;
  std::vector<std::vector<int>> groups_;
};

}  // namespace

MeasuredSurface::MeasuredSurface(const Mesh& mesh, int samples, std::uint64_t seed)
    : tree_(mesh), sample_count_(samples), seed_(seed) {
  gather_clusters();
  refresh();
}

void MeasuredSurface::move_to(std::vector<Vec3> positions) {
  FORAMEN_ASSERT(!corners_of_cluster_.empty());  // not settled
  tree_.move_to(std::move(positions));
  refresh();
}

void MeasuredSurface::settle() {
  cluster_of_face_ = {};
  corners_of_cluster_ = {};
  owned_vertices_ = {};
}

void MeasuredSurface::gather_clusters() {
  const Mesh& mesh = tree_.mesh();
  const auto groups = FaceGroups(mesh, std::max(1, mesh.face_count() / cluster_count)).take();
  cluster_of_face_.resize(mesh.face_count());
  corners_of_cluster_.resize(groups.size());
  owned_vertices_.resize(groups.size());
  clusters_.resize(groups.size());
  VertexMap<char> owned(mesh.vertex_count(), 0);
  for (std::size_t c = 0; c < groups.size(); ++c) {
    std::vector<int>& corners = corners_of_cluster_[c];
    for (const int face : groups[c]) {
      cluster_of_face_[face] = static_cast<int>(c);
      for (const VertexId v : mesh.corners(FaceId(face))) corners.push_back(v.index);
    }
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    for (const int v : corners)
      if (!std::exchange(owned[VertexId(v)], 1)) owned_vertices_[c].push_back(v);
  }
}

void MeasuredSurface::refresh() {
  const Mesh& mesh = tree_.mesh();
  const auto places = sample_surface(mesh, sample_count_, Rng(seed_));
  samples_.clear();
  std::vector<int> samples_before(clusters_.size() + 1, 0);  // counts first, then cumulative sums
  for (const SurfacePoint& p : places) {
    samples_.push_back(position(mesh, p));
    ++samples_before[static_cast<std::size_t>(cluster_of_face_[p.face.index]) + 1];
  }
  std::partial_sum(samples_before.begin(), samples_before.end(), samples_before.begin());

  points_.resize(static_cast<std::size_t>(mesh.vertex_count()) + places.size());
  int first = 0;
  for (std::size_t c = 0; c < clusters_.size(); ++c) {
    PointCluster& cluster = clusters_[c];
    // Triangles are convex, so a ball around the corners contains the samples, too.
    Vec3 low = mesh.position(VertexId(corners_of_cluster_[c][0])), high = low;
    for (const int v : corners_of_cluster_[c]) {
      low = low.cwiseMin(mesh.position(VertexId(v)));
      high = high.cwiseMax(mesh.position(VertexId(v)));
    }
    cluster.centre = 0.5 * (low + high);
    double squared = 0;
    for (const int v : corners_of_cluster_[c])
      squared = std::max(squared, (mesh.position(VertexId(v)) - cluster.centre).squaredNorm());
    cluster.radius = std::sqrt(squared);
    cluster.first = first;
    for (const int v : owned_vertices_[c]) points_[first++] = mesh.position(VertexId(v));
    cluster.count = static_cast<int>(owned_vertices_[c].size()) + samples_before[c + 1] - samples_before[c];
    first = cluster.first + cluster.count;
  }
  std::vector<int> filled(clusters_.size(), 0);
  for (std::size_t s = 0; s < places.size(); ++s) {
    const std::size_t c = cluster_of_face_[places[s].face.index];
    const int at = clusters_[c].first + static_cast<int>(owned_vertices_[c].size()) + filled[c]++;
    points_[at] = samples_[s];
  }
}

}  // namespace foramen::detail
