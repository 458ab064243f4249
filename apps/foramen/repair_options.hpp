#pragma once
/// \file
/// The options of a repair, which `repair` and `build` share.

#include "command.hpp"
#include "foramen/core/units.hpp"
#include "foramen/repair/repair_mesh.hpp"

namespace foramen::app {

/// Adds --handle-limit, --hole-limit and returns them.
std::vector<CLI::Option*> add_repair_options(CLI::App& command, RepairOptions& options);
/// Adds --units.
void add_unit_option(CLI::App& command, InputUnit& unit);

}  // namespace foramen::app
