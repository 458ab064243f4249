#pragma once
/// \file
/// The changes of a repair, as JSON.

#include <nlohmann/json_fwd.hpp>

#include "foramen/repair/repair_mesh.hpp"

namespace foramen {

/// For every kind of change, its count and its positions [mm] (at most one hundred); the removed handles with
/// their loops; the canal; and the defects that could not be repaired.
nlohmann::ordered_json repair_json(const RepairReport& report);

/// One handle: whether it is cut or filled, the lengths of its loops [mm], and its position.
nlohmann::ordered_json handle_json(const Handle& handle);

}  // namespace foramen
