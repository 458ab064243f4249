#pragma once
/// \file
/// What a repair changed, as JSON.

#include <nlohmann/json_fwd.hpp>

#include "foramen/repair/repair_mesh.hpp"

namespace foramen {

/// Every change with its count and positions [mm] (the first hundred of a kind), the handles that were
/// removed with their loops, the canal that is left, what could not be mended.
nlohmann::ordered_json repair_json(const RepairReport& report);

/// One handle: which way it is removed, its loops [mm], its position.
nlohmann::ordered_json handle_json(const Handle& handle);

}  // namespace foramen
