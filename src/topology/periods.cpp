#include "topology/periods.hpp"

#include <string>

#include "foramen/core/error.hpp"

namespace foramen {
namespace {

// Sets the value of a halfedge and its negative on the twin.
void assign(const Mesh& mesh, Cocycle& form, HalfedgeMap<bool>& known, HalfedgeId h, const Vec2i& value) {
  form.value[h] = value;
  form.value[mesh.twin(h)] = -value;
  known[h] = known[mesh.twin(h)] = true;
}

int unknown_count(FaceId f, const HalfedgeMap<bool>& known) {
  int count = 0;
  for (int k = 0; k < 3; ++k) count += known[Mesh::halfedge(f, k)] ? 0 : 1;
  return count;
}

HalfedgeId first_unknown(FaceId f, const HalfedgeMap<bool>& known) {
  for (int k = 0; k < 3; ++k)
    if (!known[Mesh::halfedge(f, k)]) return Mesh::halfedge(f, k);
  return {};
}

}  // namespace

Cocycle cocycle(const Mesh& mesh, const LoopSystem& loops) {
  if (loops.generators.size() != 2 || mesh.euler_characteristic() != 0 || !mesh.is_closed())
    throw TopologyError("a form with two periods needs a closed surface of genus 1, found Euler number " +
                        std::to_string(mesh.euler_characteristic()) + " and " +
                        std::to_string(loops.generators.size()) + " loops");
  Cocycle form{HalfedgeMap<Vec2i>(mesh.halfedge_count(), Vec2i::Zero())};
  HalfedgeMap<bool> known(mesh.halfedge_count(), false);
  for (HalfedgeId h : loops.tree_parent)
    if (h.valid()) assign(mesh, form, known, h, Vec2i::Zero());
  assign(mesh, form, known, loops.generators[0], Vec2i::UnitX());
  assign(mesh, form, known, loops.generators[1], Vec2i::UnitY());

  // The edges without a value form a spanning tree of the dual graph. A face with one such edge is a leaf,
  // and the zero sum of its values determines the missing one.
  std::vector<FaceId> leaves;
  for (FaceId f : mesh.faces())
    if (unknown_count(f, known) == 1) leaves.push_back(f);
  while (!leaves.empty()) {
    const FaceId f = leaves.back();
    leaves.pop_back();
    const HalfedgeId h = first_unknown(f, known);
    if (!h.valid()) continue;  // the last face
    assign(mesh, form, known, h, -form.value[Mesh::next(h)] - form.value[Mesh::prev(h)]);
    const FaceId other = Mesh::face(mesh.twin(h));
    if (unknown_count(other, known) == 1) leaves.push_back(other);
  }
  FORAMEN_ASSERT(is_closed_form(mesh, form));
  return form;
}

Vec2i integrate(const Cocycle& form, std::span<const HalfedgeId> walk) {
  Vec2i sum = Vec2i::Zero();
  for (HalfedgeId h : walk) sum += form.value[h];
  return sum;
}

bool is_closed_form(const Mesh& mesh, const Cocycle& form) {
  if (form.value.size() != mesh.halfedge_count()) return false;
  for (HalfedgeId h : mesh.halfedges())
    if (mesh.twin(h).valid() && form.value[mesh.twin(h)] != -form.value[h]) return false;
  for (FaceId f : mesh.faces()) {
    const HalfedgeId h = Mesh::halfedge(f, 0);
    if (form.value[h] + form.value[Mesh::next(h)] + form.value[Mesh::prev(h)] != Vec2i::Zero()) return false;
  }
  return true;
}

}  // namespace foramen
