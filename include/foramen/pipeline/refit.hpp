#pragma once
/// \file
/// Generalization with the correspondence computed anew: what a model says of a shape that no stage has seen.

#include <vector>

#include "foramen/evaluate/generalization.hpp"
#include "foramen/pipeline/build_model.hpp"

namespace foramen {

/// The model of the build's shapes without some of them (indices), by all stages anew. Where the named
/// reference is among those left out, another is chosen as `auto` does. Throws what build_model() throws.
ModelBuild build_without(const ModelBuild& build, const std::vector<int>& left_out,
                         const BuildOptions& options, const RunContext& ctx);

/// The landmarks of a finished build on a shape that is not in it, in the shape's own coordinates: the shape
/// is registered to the model as it is (register_to_group(), register_shape(), or icp_correspondence()).
/// Throws the errors of registration.
std::vector<Vec3> landmarks_on_unseen(const Mesh& shape, const ModelBuild& build, const BuildOptions& options,
                                      const RunContext& ctx);

/// For every shape, or every subject, a build without it, to which it is then registered; its errors are
/// those of generalization(), with the weights of that model. As many builds as there are shapes or
/// subjects. A shape that cannot be registered, or whose build is not possible, is among the failures. M
/// runs to the modes the smallest of the models can have.
/// \param build  of all shapes, with these options
/// \param subjects  one per shape of the build; not looked at for LeaveOut::shape
RefitGeneralization refit_generalization(const ModelBuild& build, const std::vector<std::string>& subjects,
                                         const BuildOptions& options, const GeneralizationOptions& measure,
                                         const RunContext& ctx);

}  // namespace foramen
