#pragma once
/// \file
/// The surfaces of a cohort, read and audited.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "foramen/core/run_context.hpp"
#include "foramen/core/units.hpp"
#include "foramen/io/mesh_file.hpp"
#include "foramen/repair/repair_mesh.hpp"

namespace foramen {

/// A surface fit for a model: one closed, manifold, genus-1 component, wound outward, in mm.
struct InputShape {
  std::string stem;       ///< file name without extension; names the shape everywhere
  std::string file_name;  ///< with extension, without folder
  std::string sha256;     ///< of the file's bytes
  AnatomicalSpace space = AnatomicalSpace::lps;
  bool was_inward = false;             ///< the file's triangles were wound inward and have been reversed
  std::optional<RepairReport> repair;  ///< what was changed, if the file as it is could not be used
  Mesh mesh;
};

/// A shape that takes no part, and why.
struct LeftOut {
  std::string stem, file_name, sha256;
  std::string reason;  ///< finding and remedy
};

struct Cohort {
  std::vector<InputShape> shapes;  ///< in order of stem
  std::vector<LeftOut> left_out;
};

/// The mesh files meant by files and folders (a folder means the mesh files directly in it), in order of
/// stem. Throws InvalidInput: no such path, a folder without meshes, two inputs with the same stem.
std::vector<std::filesystem::path> find_meshes(const std::vector<std::filesystem::path>& inputs);

/// Reads and audits each file. What cannot be used is left out with its reason; nothing is thrown for one bad
/// file. \param repair  set: what the audit refuses is repaired
Cohort read_cohort(const std::vector<std::filesystem::path>& files, LengthUnit unit, const RunContext& ctx,
                   const std::optional<RepairOptions>& repair = std::nullopt);

/// A raw surface repaired, in mm. Throws InvalidInput as repair_mesh does, and where the size is that of no
/// vertebra in this unit.
RepairedMesh repair_surface(TriangleSoup raw, LengthUnit unit, const RepairOptions& options,
                            const RunContext& ctx);

/// One surface fit for a model, or the reason why not as an InvalidInput or IoError.
InputShape read_shape(const std::filesystem::path& file, LengthUnit unit,
                      const std::optional<RepairOptions>& repair = std::nullopt,
                      const RunContext& ctx = RunContext());

}  // namespace foramen
