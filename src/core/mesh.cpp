#include "foramen/core/mesh.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

#include "foramen/core/error.hpp"

namespace foramen {
namespace {

std::string triangle_name(std::size_t f) { return "triangle " + std::to_string(f); }

void check_soup(const TriangleSoup& soup) {
  for (std::size_t v = 0; v < soup.points.size(); ++v)
    if (!soup.points[v].allFinite())
      throw InvalidInput("vertex " + std::to_string(v) + " has a coordinate that is not a finite number");
  const int n = static_cast<int>(soup.points.size());
  for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
    const auto& t = soup.triangles[f];
    for (int corner : t)
      if (corner < 0 || corner >= n)
        throw InvalidInput(triangle_name(f) + " uses vertex " + std::to_string(corner) +
                           ", but there are only " + std::to_string(n) + " vertices");
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
      throw InvalidInput(triangle_name(f) + " uses one vertex twice");
  }
}

struct DirectedEdge {
  int low, high;
  int halfedge;
  bool forward;  // runs from low to high
};

}  // namespace

Mesh build_mesh(TriangleSoup soup) {
  check_soup(soup);
  Mesh::Connectivity c;
  const auto halfedges = 3 * soup.triangles.size();
  std::vector<DirectedEdge> sorted;
  sorted.reserve(halfedges);
  for (std::size_t f = 0; f < soup.triangles.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = soup.triangles[f][k], b = soup.triangles[f][(k + 1) % 3];
      sorted.push_back({std::min(a, b), std::max(a, b), static_cast<int>(3 * f + k), a < b});
    }
  std::sort(sorted.begin(), sorted.end(), [](const DirectedEdge& x, const DirectedEdge& y) {
    return std::tie(x.low, x.high, x.halfedge) < std::tie(y.low, y.high, y.halfedge);
  });

  c.twin.resize(halfedges);
  c.halfedge_edge.resize(halfedges);
  std::vector<std::pair<int, HalfedgeId>> first_of_edge;
  for (std::size_t i = 0; i < sorted.size();) {
    std::size_t end = i + 1;
    while (end < sorted.size() && sorted[end].low == sorted[i].low && sorted[end].high == sorted[i].high)
      ++end;
    const std::string edge = "edge " + std::to_string(sorted[i].low) + "-" + std::to_string(sorted[i].high);
    if (end - i > 2)
      throw TopologyError(edge + " belongs to " + std::to_string(end - i) + " triangles (not manifold)");
    if (end - i == 2) {
      if (sorted[i].forward == sorted[i + 1].forward)
        throw TopologyError("the two triangles at " + edge + " are wound in opposite ways (not oriented)");
      c.twin[sorted[i].halfedge] = HalfedgeId(sorted[i + 1].halfedge);
      c.twin[sorted[i + 1].halfedge] = HalfedgeId(sorted[i].halfedge);
    } else {
      c.closed = false;
    }
    for (std::size_t k = i; k < end; ++k)
      c.halfedge_edge[sorted[k].halfedge] = EdgeId(static_cast<int>(c.edge_halfedge.size()));
    c.edge_halfedge.push_back(HalfedgeId(sorted[i].halfedge));
    i = end;
  }

  // One outgoing halfedge per vertex. At a boundary vertex it is the one without twin, because rotating
  // counter-clockwise from it reaches the whole fan.
  std::vector<int> degree(soup.points.size(), 0);
  c.vertex_halfedge.resize(soup.points.size());
  for (std::size_t h = 0; h < halfedges; ++h) {
    const std::size_t v = soup.triangles[h / 3][h % 3];
    ++degree[v];
    if (!c.vertex_halfedge[v].valid() || !c.twin[h].valid())
      c.vertex_halfedge[v] = HalfedgeId(static_cast<int>(h));
  }
  c.triangles = std::move(soup.triangles);

  Mesh mesh;
  mesh.positions_ = std::make_shared<const std::vector<Vec3>>(std::move(soup.points));
  mesh.connectivity_ = std::make_shared<const Mesh::Connectivity>(std::move(c));
  for (VertexId v : mesh.vertices()) {
    const std::size_t expected = degree[v.index];
    if (expected == 0) throw TopologyError("vertex " + std::to_string(v.index) + " belongs to no triangle");
    if (mesh.fan(v).size() != expected)
      throw TopologyError("the triangles at vertex " + std::to_string(v.index) +
                          " do not form one fan (not manifold)");
  }
  return mesh;
}

std::vector<HalfedgeId> Mesh::fan(VertexId v) const {
  std::vector<HalfedgeId> out;
  const HalfedgeId first = outgoing(v);
  HalfedgeId h = first;
  do {
    out.push_back(h);
    h = rotated(h);
  } while (h.valid() && h != first);
  return out;
}

HalfedgeId Mesh::find_halfedge(VertexId a, VertexId b) const {
  const HalfedgeId first = outgoing(a);
  HalfedgeId h = first;
  do {
    if (to(h) == b) return h;
    h = rotated(h);
  } while (h.valid() && h != first);
  return {};
}

Mesh Mesh::with_positions(std::vector<Vec3> positions) const {
  FORAMEN_ASSERT(static_cast<int>(positions.size()) == vertex_count());
  Mesh copy = *this;
  copy.positions_ = std::make_shared<const std::vector<Vec3>>(std::move(positions));
  return copy;
}

}  // namespace foramen
