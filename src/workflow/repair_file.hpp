#pragma once
/// \file
/// The repair of one surface, from file to file.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "foramen/core/remedy.hpp"
#include "foramen/core/run_context.hpp"
#include "foramen/core/units.hpp"
#include "foramen/repair/repair_mesh.hpp"

namespace foramen {

struct RepairRequest {
  std::filesystem::path input;   ///< a mesh file
  std::filesystem::path output;  ///< the file to write, .ply or .vtp
  InputUnit unit = {};           ///< of the input and of what is written
  RepairOptions options = {};
};

struct RepairSummary {
  std::optional<Message> refusal;  ///< why the surface cannot be repaired; if set, nothing was written
  std::vector<std::string> lines;  ///< what was changed and written, for a terminal
  std::string json;                ///< the same information as one JSON object, and where each vertex was
  std::vector<Message> notes;      ///< what the user should know though it is no error
};

/// Writes the surface as one closed manifold of genus 1. A surface that cannot be repaired is refused by
/// value, so that the notes on its file are not lost. Throws InvalidInput if the output is of another kind of
/// file, ConvergenceError, IoError.
RepairSummary repair_file(const RepairRequest& request, const RunContext& ctx);

}  // namespace foramen
