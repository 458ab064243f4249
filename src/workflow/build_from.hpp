#pragma once
/// \file
/// All stages on the surfaces of a cohort that has been read.

#include "modelfiles/build_record.hpp"

namespace foramen {

/// The surfaces with their stems as names.
std::vector<Shape> surfaces_of(const std::vector<InputShape>& inputs);

/// Calls build_model() for the surfaces of a cohort. The reference may also be given by its file name. Throws
/// what build_model() throws. If too few shapes are usable, the message also names the shapes that were left
/// out when the files were read.
BuildRecord build_from(Cohort cohort, BuildOptions options, const RunContext& ctx);

}  // namespace foramen
