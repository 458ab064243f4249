#pragma once
/// \file
/// A registered shape and a reference as bytes (byte_archive.hpp), for the store.

#include "core/byte_archive.hpp"
#include "correspond/register_shape.hpp"
#include "foramen/correspond/registration_frame.hpp"

namespace foramen {

template <class Archive>
void transfer(Archive& archive, MaybeConst<TorusMap> auto& map) {
  archive(map.lattice, map.turns, map.jumps);
}

template <class Archive>
void transfer(Archive& archive, MaybeConst<MapCertificate> auto& c) {
  archive(c.triangles, c.flipped, c.smallest_area_ratio, c.largest_area_ratio, c.degree,
          c.periods_consistent);
}

template <class Archive>
void transfer(Archive& archive, MaybeConst<ShapeMap> auto& map) {
  archive(map.map, map.certificate, map.iterations, map.initial_energy, map.final_energy, map.distortion);
}

template <class Archive>
void transfer(Archive& archive, MaybeConst<Alignment> auto& a) {
  archive(a.transform, a.residual, a.second_best, a.iterations, a.converged);
}

template <class Archive>
void transfer(Archive& archive, MaybeConst<RegisteredShape> auto& shape) {
  archive(shape.alignment, shape.shape_map, shape.homology, shape.seifert, shape.agreement);
}

template <class Archive>
void transfer(Archive& archive, MaybeConst<LoopSystem> auto& loops) {
  archive(loops.basepoint, loops.loops, loops.generators, loops.tree_parent, loops.length);
}

template <class Archive>
void transfer(Archive& archive, MaybeConst<ReferenceLoops> auto& loops) {
  archive(loops.mesh, loops.loops, loops.seifert);
}

template <class Archive>
void transfer(Archive& archive, MaybeConst<Reference> auto& reference) {
  archive(reference.loops, reference.shape_map);
}

}  // namespace foramen
