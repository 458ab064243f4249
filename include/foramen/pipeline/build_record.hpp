#pragma once
/// \file
/// A model built of read shapes, with where they come from.

#include <string>
#include <vector>

#include "foramen/pipeline/read_cohort.hpp"
#include "foramen/stages/build_model.hpp"

namespace foramen {

struct BuildRecord {
  std::vector<InputShape> inputs;  ///< of the model's shapes, in its order
  std::vector<LeftOut> left_out;   ///< when reading or registering
  std::vector<std::string> notes;  ///< what the user should know though it is no error
  BuiltModel built;
};

/// The surfaces alone, by their stems.
std::vector<Shape> surfaces_of(const std::vector<InputShape>& inputs);

/// build_model() of the surfaces of a cohort. The reference may also be named by its file. Throws what
/// build_model() throws; where too few shapes are usable, the message names those left out when reading, too.
BuildRecord build_from(Cohort cohort, BuildOptions options, const RunContext& ctx);

}  // namespace foramen
