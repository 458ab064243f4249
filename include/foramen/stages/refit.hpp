#pragma once
/// \file
/// Generalization with recomputed correspondence: how well a model describes a shape that no stage has used.

#include <span>
#include <string>
#include <vector>

#include "foramen/evaluate/generalization.hpp"
#include "foramen/stages/build_model.hpp"

namespace foramen {

/// Builds the model of the shapes without some of them (indices) by all stages. If the named reference is
/// left out, another one is chosen as with "auto". Throws what build_model() throws.
BuiltModel build_without(std::span<const Shape> shapes, const std::vector<int>& left_out,
                         const BuildOptions& options, const RunContext& ctx);

/// For every shape (or every subject), builds a model without it and registers it to this model. The errors
/// are defined as in generalization(), with the landmark weights of that model. There are as many builds as
/// shapes or subjects. A shape that cannot be registered, or whose build fails, is listed in the failures. M
/// goes up to the number of modes that the smallest of the models can have.
/// \param shapes  the shapes of the model
/// \param subjects  one per shape; ignored for LeaveOut::shape
/// \param options  options of the builds
RefitGeneralization refit_generalization(std::span<const Shape> shapes,
                                         const std::vector<std::string>& subjects,
                                         const BuildOptions& options, const GeneralizationOptions& measure,
                                         const RunContext& ctx);

}  // namespace foramen
