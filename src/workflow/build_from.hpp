#pragma once
/// \file
/// The stages on the surfaces of a cohort that was read.

#include "modelfiles/build_record.hpp"

namespace foramen {

/// The surfaces alone, by their stems.
std::vector<Shape> surfaces_of(const std::vector<InputShape>& inputs);

/// build_model() of the surfaces of a cohort. The reference may also be named by its file. Throws what
/// build_model() throws; where too few shapes are usable, the message names those left out when reading, too.
BuildRecord build_from(Cohort cohort, BuildOptions options, const RunContext& ctx);

}  // namespace foramen
