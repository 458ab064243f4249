#include "modelfiles/atlas.hpp"

#include "foramen/stages/build_model.hpp"

namespace foramen {

Atlas atlas_of(const BuiltModel& built) {
  Atlas atlas;
  const Reference& reference = built.registration.frame.reference;
  atlas.surface = reference.mesh();
  atlas.map = reference.shape_map.map;
  for (std::size_t k = 0; k < 2; ++k)
    for (HalfedgeId h : reference.loops.loops.loops[k]) atlas.loops[k].push_back(atlas.surface.from(h));
  atlas.landmarks = built.landmarks.mesh;
  atlas.curvatures = mean_surface(built).curvatures.values();
  atlas.names = built.landmarks.names;
  for (const SimilarityTransform& transform : built.aligned.alignment.transforms)
    atlas.transforms.push_back(transform.matrix());
  return atlas;
}

}  // namespace foramen
