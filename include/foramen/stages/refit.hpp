#pragma once
/// \file
/// Generalization with the correspondence computed anew: what a model says of a shape that no stage has seen.

#include <span>
#include <string>
#include <vector>

#include "foramen/evaluate/generalization.hpp"
#include "foramen/stages/build_model.hpp"

namespace foramen {

/// The model of the shapes without some of them (indices), by all stages anew. Where the named reference is
/// among those left out, another is chosen as `auto` does. Throws what build_model() throws.
BuiltModel build_without(std::span<const Shape> shapes, const std::vector<int>& left_out,
                         const BuildOptions& options, const RunContext& ctx);

/// For every shape, or every subject, a build without it, to which it is then registered; its errors are
/// those of generalization(), with the weights of that model. As many builds as there are shapes or
/// subjects. A shape that cannot be registered, or whose build is not possible, is among the failures. M
/// runs to the modes the smallest of the models can have.
/// \param shapes  those that are in the model
/// \param subjects  one per shape; not looked at for LeaveOut::shape
/// \param options  of the build
RefitGeneralization refit_generalization(std::span<const Shape> shapes,
                                         const std::vector<std::string>& subjects,
                                         const BuildOptions& options, const GeneralizationOptions& measure,
                                         const RunContext& ctx);

}  // namespace foramen
