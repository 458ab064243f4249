#pragma once
/// \file
/// Private to correspond: the state of a member of a group as bytes, for the store.

#include "core/kept_results.hpp"
#include "correspond/member_steps.hpp"
#include "correspond/registered_archive.hpp"
#include "parameterize/optimise_map.hpp"

namespace foramen {

template <class Archive>
void transfer(Archive& archive, MaybeConst<Collapse> auto& collapse) {
  archive(collapse.removed, collapse.kept, collapse.dropped_faces, collapse.dropped_corners,
          collapse.moved_faces);
}

template <class Archive>
void transfer(Archive& archive, MaybeConst<WorkingMesh> auto& working) {
  archive(working.mesh, working.vertex_origin, working.face_origin, working.collapses);
}

template <class Archive>
void transfer(Archive& archive, MaybeConst<OptimisedMap> auto& map) {
  archive(map.map, map.status, map.iterations, map.initial_energy, map.final_energy, map.distortion,
          map.energies);
}

template <class Archive>
void transfer(Archive& archive, MaybeConst<MemberState> auto& state) {
  archive(state.result, state.map, state.to_template, state.bent);
}

}  // namespace foramen
