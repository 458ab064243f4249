#pragma once
/// \file
/// A model and the origin of its shapes.

#include <string>
#include <vector>

#include "foramen/stages/build_model.hpp"
#include "inputs/read_cohort.hpp"

namespace foramen {

struct BuildRecord {
  std::vector<InputShape> inputs;  ///< of the model's shapes, in its order
  std::vector<LeftOut> left_out;   ///< when reading or registering
  std::vector<Message> notes;      ///< what the user should know though it is no error
  BuiltModel built;
};

}  // namespace foramen
