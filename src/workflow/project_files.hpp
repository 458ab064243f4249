#pragma once
/// \file
/// What a model says of new surfaces, from files to files.

#include <filesystem>
#include <string>
#include <vector>

#include "foramen/core/remedy.hpp"
#include "foramen/core/run_context.hpp"
#include "foramen/core/units.hpp"

namespace foramen {

struct ProjectRequest {
  std::filesystem::path model;                  ///< a model's folder
  std::vector<std::filesystem::path> surfaces;  ///< mesh files and folders of them
  std::filesystem::path output;                 ///< folder to write
  /// Training shapes that are left out for a second distance; empty: the one of the surface's own name.
  std::vector<std::string> leave_out = {};
  LengthUnit unit = LengthUnit::millimetre;  ///< of the surfaces and of what is written
};

struct ProjectSummary {
  /// What became of one surface.
  struct Line {
    Message message;
    bool failed = false;
  };
  std::vector<Line> lines;     ///< in order of stem
  std::vector<Message> notes;  ///< what the user should know though it is no error
  std::string json;            ///< what project.json holds
};

/// Registers every surface to the mean and writes, into the output folder, corresponding/STEM.ply (its
/// landmarks), fit/STEM.ply (the model's closest shape) and residual/STEM.ply (the surface), the last two
/// with the distance to each other; scores.csv and project.json. One bad surface does not stop the others.
/// Throws IoError for the model, InvalidInput if there is no surface or a shape to leave out is not the
/// model's.
ProjectSummary project_files(const ProjectRequest& request, const RunContext& ctx);

}  // namespace foramen
