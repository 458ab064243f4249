#pragma once
/// \file
/// The surfaces of a cohort, read or extracted from label maps, and audited.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "extract/extract_labels.hpp"
#include "foramen/core/run_context.hpp"
#include "foramen/core/units.hpp"
#include "foramen/io/mesh_file.hpp"
#include "foramen/repair/repair_mesh.hpp"
#include "inputs/find_files.hpp"

namespace foramen {

/// A surface that can be used for a model: one closed, manifold component of genus 1, wound outward, in mm.
struct InputShape {
  std::string
      stem;  ///< file name without extension, plus _ and the label's name if there is one; the shape's name
  std::string file_name;    ///< with extension, see ShapeFile::shown()
  std::string folder = {};  ///< tells the files of the cohort apart, see ShapeFile; empty if their names do
  std::string sha256;       ///< of the file's bytes
  AnatomicalSpace space = AnatomicalSpace::lps;
  bool was_inward = false;                  ///< the file's triangles were wound inward and have been reversed
  std::optional<int> label = std::nullopt;  ///< set if the shape comes from a label map
  ExtractionReport extraction = {};         ///< set if the shape comes from a label map
  std::string names_from = {};              ///< how the label got its name, see LabelSurfaces; set as above
  std::optional<RepairReport> repair = std::nullopt;  ///< the changes, if the surface had to be repaired
  std::vector<Message> notes = {};                    ///< on how the file was read
  std::optional<Message> size_note =
      std::nullopt;  ///< set if no vertebra has the size, but the unit is certain
  Mesh mesh;
};

/// An input that is not used, and why.
struct LeftOut {
  std::string stem, file_name, sha256;
  Message reason;                           ///< what was found and what to do
  std::optional<int> label = std::nullopt;  ///< of a label map; unset also for a whole label map
};

/// The origin of a shape, as text for users: "L1.ply", or "verse004.nii.gz, label 20".
std::string source_of(const InputShape& shape);
std::string source_of(const LeftOut& shape);

struct Cohort {
  std::vector<InputShape> shapes;  ///< in order of stem
  std::vector<LeftOut> left_out;
  std::vector<Message> notes;  ///< what the user should know though it is no error
};

/// What an error says about a file, without the file's name at the beginning, for a list that names its
/// files.
Message reason_without_name(const std::exception& error, const std::filesystem::path& file);

/// Reads and audits each file: meshes in the given unit, and the requested labels of label maps. A surface
/// that cannot be used is left out with its reason; a bad file is no reason to throw. Throws InvalidInput if
/// two shapes have the same stem, or if a label that was requested by itself is in no label map.
/// \param repair  if set, surfaces that the audit refuses are repaired. Surfaces of labels are always
/// repaired.
Cohort read_cohort(const std::vector<ShapeFile>& files, const InputUnit& unit, const RunContext& ctx,
                   const LabelRequest& labels = {},
                   const std::optional<RepairOptions>& repair = std::nullopt);

/// Returns the shape with this surface, audited, and repaired if repair is requested and necessary. The other
/// members of the shape are already set. Throws InvalidInput with the reason if the surface cannot be used.
/// Both surfaces of files and surfaces of labels are checked by this function.
InputShape usable_shape(InputShape shape, TriangleSoup surface, const InputUnit& unit,
                        const std::optional<RepairOptions>& repair = std::nullopt,
                        const RunContext& ctx = RunContext());

/// The note of check_size() on a surface in mm; throws as check_size() does.
std::optional<Message> size_note(const Mesh& mesh, const InputUnit& unit);

/// Repairs a raw surface and converts it to mm. Throws InvalidInput as repair_mesh() does, and if no vertebra
/// has this size in this unit.
RepairedMesh repair_surface(TriangleSoup raw, const InputUnit& unit, const RepairOptions& options,
                            const RunContext& ctx);

/// Reads one surface that can be used for a model. Throws InvalidInput or IoError with the reason if it
/// cannot be used.
InputShape read_shape(const std::filesystem::path& file, const InputUnit& unit,
                      const std::optional<RepairOptions>& repair = std::nullopt,
                      const RunContext& ctx = RunContext());

}  // namespace foramen
