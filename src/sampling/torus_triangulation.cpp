#include "sampling/torus_triangulation.hpp"

#include <algorithm>
#include <map>

#include "foramen/sampling/landmark_mesh.hpp"

namespace foramen::detail {

TorusTriangulation::TorusTriangulation(const Mesh& mesh, const TorusMap& map)
    : TorusTriangulation(map.turns.values(), mesh.triangles(), map.jumps) {}

TorusTriangulation::TorusTriangulation(const std::vector<Vec2>& turns,
                                       const std::vector<std::array<int, 3>>& triangles,
                                       const HalfedgeMap<Vec2i>& jumps)
    : jump_(jumps.values()),
      face_alive_(triangles.size(), 1),
      live_vertices_(static_cast<int>(turns.size())) {
  FORAMEN_ASSERT(jump_.size() == 3 * triangles.size());
  place_.reserve(turns.size());
  for (const Vec2& t : turns) place_.push_back(to_fixed(t));
  from_.reserve(jump_.size());
  for (const auto& t : triangles) from_.insert(from_.end(), t.begin(), t.end());
  connect_twins();
}

void TorusTriangulation::connect_twins() {
  outgoing_.assign(place_.size(), -1);
  twin_.assign(from_.size(), -1);
  struct Side {
    int low, high, halfedge;
    auto operator<=>(const Side&) const = default;
  };
  std::vector<Side> sides;
  sides.reserve(from_.size());
  for (int h = 0; h < halfedge_slots(); ++h) {
    outgoing_[from(h)] = h;
    sides.push_back({std::min(from(h), to(h)), std::max(from(h), to(h)), h});
  }
  std::sort(sides.begin(), sides.end());
  FORAMEN_ASSERT(sides.size() % 2 == 0);
  for (std::size_t i = 0; i < sides.size(); i += 2) {
    const Side &a = sides[i], &b = sides[i + 1];
    FORAMEN_ASSERT(a.low == b.low && a.high == b.high && from(a.halfedge) == to(b.halfedge));
    FORAMEN_ASSERT(jump_[a.halfedge] == -jump_[b.halfedge]);
    glue(a.halfedge, b.halfedge);
  }
  FORAMEN_ASSERT(std::find(outgoing_.begin(), outgoing_.end(), -1) == outgoing_.end());
}

int TorusTriangulation::valence(int v) const {
  int count = 0;
  for_each_outgoing(v, [&](int) { ++count; });
  return count;
}

bool TorusTriangulation::adjacent(int a, int b) const {
  bool found = false;
  for_each_outgoing(a, [&](int h) { found |= to(h) == b; });
  return found;
}

bool TorusTriangulation::can_flip(int h) const {
  const int t = twin_[h];
  const int c = apex(h), d = apex(t);
  if (c == d || adjacent(c, d)) return false;
  const Fixed2 db = along(prev(t)), dc = db + along(next(h)), da = -along(next(t));
  const Int128 both = doubled_area(h / 3) + doubled_area(t / 3);
  return keeps_area(cross(db, dc), both) && keeps_area(cross(dc, da), both);
}

int TorusTriangulation::flip(int h) {
  const int t = twin_[h];
  const int a = from(h), b = to(h), c = apex(h), d = apex(t);
  const int bc = next(h), ca = prev(h), ad = next(t), db = prev(t);
  const std::array outer{twin_[bc], twin_[ca], twin_[ad], twin_[db]};
  const Vec2i jump_bc = jump_[bc], jump_ca = jump_[ca], jump_ad = jump_[ad], jump_db = jump_[db];
  const Vec2i jump_dc = jump_db + jump_bc;
  const int f = h / 3, g = t / 3;
  set_face(f, {d, b, c}, {jump_db, jump_bc, Vec2i(-jump_dc)});
  set_face(g, {d, c, a}, {jump_dc, jump_ca, jump_ad});
  glue(3 * f + 1, outer[0]);
  glue(3 * g + 1, outer[1]);
  glue(3 * g + 2, outer[2]);
  glue(3 * f, outer[3]);
  glue(3 * f + 2, 3 * g);
  outgoing_[a] = 3 * g + 2;
  outgoing_[b] = 3 * f + 1;
  outgoing_[c] = 3 * g + 1;
  outgoing_[d] = 3 * g;
  return 3 * g;
}

bool TorusTriangulation::can_collapse(int h) const {
  const int u = from(h), w = to(h), c = apex(h), d = apex(twin_[h]);
  if (c == d) return false;
  // Link condition: the only common neighbours of u and w are the two apexes. (There is no boundary, and no
  // two edges join the same vertices.)
  bool other = false;
  for_each_outgoing(u, [&](int g) {
    const int x = to(g);
    if (x != w && x != c && x != d && adjacent(x, w)) other = true;
  });
  if (other || valence(c) <= 3 || valence(d) <= 3) return false;
  // The remaining faces of u must be positive with u moved to w.
  const Fixed2 uw = along(h);
  bool positive = true;
  for_each_outgoing(u, [&](int g) {
    if (g / 3 == h / 3 || g / 3 == twin_[h] / 3) return;
    const Fixed2 ux = along(g);
    if (cross(ux - uw, along(next(g))) <= 0) positive = false;
  });
  return positive;
}

void TorusTriangulation::collapse(int h) {
  const int t = twin_[h];
  const int u = from(h), w = to(h), c = apex(h), d = apex(t);
  const Vec2i jump_wu = jump_[t];
  std::vector<int> fan;
  for_each_outgoing(u, [&](int g) { fan.push_back(g); });
  for (int g : fan) {
    from_[g] = w;
    jump_[g] += jump_wu;
    jump_[prev(g)] -= jump_wu;
  }
  const int wc = twin_[next(h)], cu = twin_[prev(h)], ud = twin_[next(t)], dw = twin_[prev(t)];
  glue(wc, cu);
  glue(ud, dw);
  face_alive_[h / 3] = face_alive_[t / 3] = 0;
  outgoing_[u] = -1;
  outgoing_[c] = from(wc) == c ? wc : cu;
  outgoing_[d] = from(ud) == d ? ud : dw;
  outgoing_[w] = from(wc) == w ? wc : cu;
  --live_vertices_;
}

int TorusTriangulation::split_edge(int h, double fraction) {
  const int t = twin_[h];
  const int a = from(h), b = to(h), c = apex(h), d = apex(t);
  const Fixed2 ab = along(h);
  const Fixed2 am{std::llround(fraction * static_cast<double>(ab.x)),
                  std::llround(fraction * static_cast<double>(ab.y))};
  const Fixed2 ac = -along(prev(h)), ad = along(next(t));
  const bool positive =
      cross(am, ac) > 0 && cross(ac - ab, am - ab) > 0 && cross(ad, am) > 0 && cross(am - ab, ad - ab) > 0;
  if (!positive) return -1;

  const int bc = next(h), ca = prev(h), ad_edge = next(t), db = prev(t);
  const int outer_bc = twin_[bc], outer_ca = twin_[ca], outer_ad = twin_[ad_edge], outer_db = twin_[db];
  const Vec2i jump_ab = jump_[h], jump_bc = jump_[bc], jump_ca = jump_[ca], jump_ad = jump_[ad_edge],
              jump_db = jump_[db];
  const int m =
      add_vertex(place_[a] + am);  // relative to the position of a: no jump from a to m, jump_ab from m to b
  const int f = h / 3, g = t / 3, f2 = add_face(), g2 = add_face();
  const Vec2i zero = Vec2i::Zero();
  set_face(f, {a, m, c}, {zero, Vec2i(-jump_ca), jump_ca});
  set_face(f2, {m, b, c}, {jump_ab, jump_bc, jump_ca});
  set_face(g, {m, a, d}, {zero, jump_ad, Vec2i(-jump_ad)});
  set_face(g2, {b, m, d}, {Vec2i(-jump_ab), jump_ad, jump_db});
  glue(3 * f, 3 * g);
  glue(3 * f + 1, 3 * f2 + 2);
  glue(3 * f + 2, outer_ca);
  glue(3 * f2, 3 * g2);
  glue(3 * f2 + 1, outer_bc);
  glue(3 * g + 1, outer_ad);
  glue(3 * g + 2, 3 * g2 + 1);
  glue(3 * g2 + 2, outer_db);
  outgoing_[a] = 3 * f;
  outgoing_[m] = 3 * f2;
  outgoing_[b] = 3 * f2 + 1;
  outgoing_[c] = 3 * f + 2;
  outgoing_[d] = 3 * g2 + 2;
  return m;
}

int TorusTriangulation::split_face(int f) {
  const auto [a, b, c] = corners(f);
  const Fixed2 ab = along(3 * f), ac = -along(3 * f + 2);
  const Fixed2 am{(ab.x + ac.x) / 3, (ab.y + ac.y) / 3};
  if (cross(ab, am) <= 0 || cross(ac - ab, am - ab) <= 0 || cross(am, ac) <= 0) return -1;
  const std::array outer{twin_[3 * f], twin_[3 * f + 1], twin_[3 * f + 2]};
  const Vec2i jump_ab = jump_[3 * f], jump_bc = jump_[3 * f + 1], jump_ca = jump_[3 * f + 2];
  const Vec2i zero = Vec2i::Zero();
  const int m = add_vertex(place_[a] + am), g = add_face(), k = add_face();
  set_face(f, {a, b, m}, {jump_ab, Vec2i(-jump_ab), zero});
  set_face(g, {b, c, m}, {jump_bc, jump_ca, jump_ab});
  set_face(k, {c, a, m}, {jump_ca, zero, Vec2i(-jump_ca)});
  glue(3 * f, outer[0]);
  glue(3 * g, outer[1]);
  glue(3 * k, outer[2]);
  glue(3 * f + 1, 3 * g + 2);
  glue(3 * g + 1, 3 * k + 2);
  glue(3 * k + 1, 3 * f + 2);
  outgoing_[a] = 3 * f;
  outgoing_[b] = 3 * g;
  outgoing_[c] = 3 * k;
  outgoing_[m] = 3 * f + 2;
  return m;
}

LandmarkMesh TorusTriangulation::landmark_mesh() const {
  LandmarkMesh out;
  std::vector<int> number(place_.size(), -1);
  std::vector<Vec2i> floor(place_.size(), Vec2i::Zero());
  for (int v = 0; v < vertex_slots(); ++v) {
    if (!alive(v)) continue;
    number[v] = static_cast<int>(out.turns.size());
    floor[v] = floor_turns(place_[v]);
    out.turns.push_back(to_turns(place_[v] - whole_turns(floor[v])));
  }
  std::vector<Vec2i> jumps;
  for (int f = 0; f < face_slots(); ++f) {
    if (!face_alive(f)) continue;
    const auto c = corners(f);
    out.triangles.push_back({number[c[0]], number[c[1]], number[c[2]]});
    for (int k = 0; k < 3; ++k) jumps.push_back(jump_[3 * f + k] + floor[c[(k + 1) % 3]] - floor[c[k]]);
  }
  out.jumps = HalfedgeMap<Vec2i>(std::move(jumps));
  return out;
}

void TorusTriangulation::set_face(int f, std::array<int, 3> corners, std::array<Vec2i, 3> jumps) {
  for (int k = 0; k < 3; ++k) {
    from_[3 * f + k] = corners[k];
    jump_[3 * f + k] = jumps[k];
  }
}

void TorusTriangulation::glue(int h, int g) {
  twin_[h] = g;
  twin_[g] = h;
}

int TorusTriangulation::add_vertex(Fixed2 place) {
  place_.push_back(place);
  outgoing_.push_back(-1);
  ++live_vertices_;
  return vertex_slots() - 1;
}

int TorusTriangulation::add_face() {
  from_.resize(from_.size() + 3, -1);
  twin_.resize(twin_.size() + 3, -1);
  jump_.resize(jump_.size() + 3, Vec2i::Zero());
  face_alive_.push_back(1);
  return face_slots() - 1;
}

}  // namespace foramen::detail
