#pragma once
/// \file
/// The audit of a mesh file.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "foramen/core/remedy.hpp"
#include "foramen/core/run_context.hpp"
#include "foramen/core/units.hpp"
#include "foramen/io/mesh_file.hpp"
#include "foramen/repair/handles.hpp"
#include "foramen/topology/inspect_mesh.hpp"

namespace foramen {

struct InspectRequest {
  std::filesystem::path file;
  InputUnit unit = {};       ///< of the file
  bool find_handles = true;  ///< finding them takes longer than everything else
};

struct InspectedFile {
  std::filesystem::path file;
  std::optional<Message> error;  ///< why the file cannot be inspected; if set, nothing below is
  MeshReport report = {};        ///< lengths in mm
  std::string size_unit = {};    ///< "mm", or what the size says of the unit if no vertebra has this size
  std::optional<AnatomicalSpace> space = std::nullopt;  ///< the axes that the file names
  std::vector<Message> notes = {};                      ///< what was passed over in the file
  /// The handles of a surface that has more than the canal; unset if they cannot be determined.
  std::optional<SurfaceHandles> handles = std::nullopt;

  /// Whether a model can be made of the surface.
  bool usable() const { return !error && !obstacle_to_model(report); }
};

/// Reads and audits one file. What is wrong with it is in the result. Throws Cancelled.
InspectedFile inspect_file(const InspectRequest& request, const RunContext& ctx);

/// The audit as one object.
nlohmann::ordered_json inspection_json(const InspectedFile& inspected);

}  // namespace foramen
