#pragma once
/// \file
/// The audit of a surface as JSON.

#include <nlohmann/json_fwd.hpp>

#include "foramen/topology/inspect_mesh.hpp"

namespace foramen {

/// All members of the report. `usable` says whether the surface can be used for a model; if it cannot,
/// `finding` and `remedy` say why and what to do. `likely_units` is the unit that the size suggests: mm, cm,
/// m, um or null.
nlohmann::ordered_json mesh_report_json(const MeshReport& report);

/// Whether the surface has the size of a vertebra if its unit is mm.
bool is_in_millimetres(const MeshReport& report);

}  // namespace foramen
