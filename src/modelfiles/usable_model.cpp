#include "modelfiles/usable_model.hpp"

#include <cmath>
#include <utility>

#include "foramen/core/error.hpp"
#include "foramen/correspond/registration_frame.hpp"
#include "modelfiles/atlas_file.hpp"

namespace foramen {
namespace {

constexpr double scale_rounding = 1e-9;

// Sizes were removed if the transforms of the shapes into model coordinates have other scales than 1.
ScaleMode scale_of(const Atlas& atlas) {
  for (const Eigen::Matrix4d& transform : atlas.transforms)
    if (std::abs(transform.topLeftCorner<3, 3>().determinant() - 1) > scale_rounding)
      return ScaleMode::remove;
  return ScaleMode::keep;
}

}  // namespace

UsableModel read_usable_model(const std::filesystem::path& folder) {
  LoadedModel loaded = load_model(folder);
  if (!std::filesystem::exists(folder / "atlas.h5"))
    throw IoError(folder.string() +
                      ": has no maps of its shapes (atlas.h5), which only the folder of a build "
                      "holds; give such a folder, or build the model",
                  {{RemedyKind::build_model}});
  return usable_model(std::move(loaded), folder);
}

UsableModel usable_model(LoadedModel loaded, const std::filesystem::path& folder) {
  Atlas atlas = read_atlas(folder / "atlas.h5");
  const bool fits = std::ssize(atlas.names) == loaded.scores.cols() &&
                    atlas.landmarks.triangles == loaded.model.triangles() &&
                    std::ssize(atlas.landmarks.turns) == loaded.model.landmarks();
  if (!fits)
    throw IoError(folder.string() +
                  ": its files are not of one model (shapes or landmarks differ); build it again");
  UsableModel usable;
  usable.scale = scale_of(atlas);
  usable.space = loaded.space;
  usable.names = std::move(atlas.names);
  usable.landmarks = std::move(atlas.landmarks);
  usable.curvatures = std::move(atlas.curvatures);
  usable.lattice = atlas.map.lattice;
  usable.aligned.alignment.mean = unflattened(loaded.model.mean());
  for (Eigen::Index i = 0; i < loaded.scores.cols(); ++i)
    usable.aligned.alignment.aligned.push_back(unflattened(
        loaded.model.reconstruct(loaded.scores.col(i).cwiseProduct(loaded.model.variance().cwiseSqrt()))));
  usable.aligned.model = std::move(loaded.model);
  return usable;
}

MeanRegistrar registrar_of(const UsableModel& model, const RunContext& ctx) {
  const TemplateSurface mean{build_mesh({model.aligned.alignment.mean, model.landmarks.triangles}),
                             {model.lattice, VertexMap<Vec2>(model.landmarks.turns), model.landmarks.jumps},
                             VertexMap<Vec2>(model.curvatures)};
  return {mean, model.aligned.alignment.aligned, ctx};
}

}  // namespace foramen
