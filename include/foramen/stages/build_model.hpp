#pragma once
/// \file
/// From surfaces to a statistical shape model: all stages in one call.

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "foramen/correspond/registration_frame.hpp"
#include "foramen/landmarks/place_landmarks.hpp"
#include "foramen/model/build_shape_model.hpp"

namespace foramen {

/// The options of each stage.
struct BuildOptions {
  CorrespondOptions correspondence = {};
  PlaceLandmarksOptions landmarks = {};
  ShapeModelOptions model = {};
};
template <class Visitor>
void describe(Visitor& visit, MaybeConst<BuildOptions> auto& o) {
  visit(o.correspondence, {.name = "correspondence"});
  visit(o.landmarks, {.name = "landmarks"});
  visit(o.model, {.name = "model"});
}

/// The results of the stages. All three have the same shapes in the same order.
struct BuiltModel {
  CohortRegistration registration;
  Landmarks landmarks;
  AlignedModel aligned;
  std::vector<std::pair<std::string, double>> stage_seconds;
};

/// Calls correspond(), place_landmarks() and build_shape_model(). Throws what these throw.
BuiltModel build_model(std::span<const Shape> shapes, const BuildOptions& options, const RunContext& ctx);

/// The mean of the model with the map of its landmarks to the torus, to which new surfaces can be registered
/// (MeanRegistrar).
TemplateSurface mean_surface(const BuiltModel& built);

}  // namespace foramen
