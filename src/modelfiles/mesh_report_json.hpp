#pragma once
/// \file
/// The audit of a surface for other programs.

#include <nlohmann/json_fwd.hpp>

#include "foramen/topology/inspect_mesh.hpp"

namespace foramen {

/// Everything a report holds, whether the surface can be used for a model (usable; if not, finding and
/// remedy) and the unit its size suggests (likely_units: mm, cm, m, um or null).
nlohmann::ordered_json mesh_report_json(const MeshReport& report);

/// Whether its size is that of a vertebra in mm.
bool is_in_millimetres(const MeshReport& report);

}  // namespace foramen
