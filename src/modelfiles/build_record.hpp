#pragma once
/// \file
/// A model and the origin of its shapes.

#include <string>
#include <vector>

#include "foramen/stages/build_model.hpp"
#include "inputs/read_cohort.hpp"

namespace foramen {

struct BuildRecord {
  std::vector<InputShape> inputs;  ///< the shapes of the model, in its order
  std::vector<LeftOut> left_out;   ///< inputs that could not be read or registered
  std::vector<std::string> notes;  ///< remarks for the user that are no errors
  BuiltModel built;
};

}  // namespace foramen
