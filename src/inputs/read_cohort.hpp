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

namespace foramen {

/// A surface fit for a model: one closed, manifold, genus-1 component, wound outward, in mm.
struct InputShape {
  std::string
      stem;  ///< file name without extension, and for a label _ and its name; names the shape everywhere
  std::string file_name;  ///< with extension, without folder
  std::string sha256;     ///< of the file's bytes
  AnatomicalSpace space = AnatomicalSpace::lps;
  bool was_inward = false;                  ///< the file's triangles were wound inward and have been reversed
  std::optional<int> label = std::nullopt;  ///< of a label map
  ExtractionReport extraction = {};         ///< if so
  std::optional<RepairReport> repair =
      std::nullopt;  ///< what was changed, if the surface as it is could not be used
  Mesh mesh;
};

/// A shape that takes no part, and why.
struct LeftOut {
  std::string stem, file_name, sha256;
  Message reason;                           ///< what was found and what to do
  std::optional<int> label = std::nullopt;  ///< of a label map; unset also for a whole label map
};

/// Where a shape comes from, for people: "L1.ply", or "verse004.nii.gz, label 20".
std::string source_of(const InputShape& shape);
std::string source_of(const LeftOut& shape);

struct Cohort {
  std::vector<InputShape> shapes;  ///< in order of stem
  std::vector<LeftOut> left_out;
  std::vector<Message> notes;  ///< what the user should know though it is no error
};

/// The mesh files meant by files and folders (a folder means the mesh files directly in it), in order of
/// stem. Throws InvalidInput: no such path, a folder without meshes, two inputs with the same stem.
std::vector<std::filesystem::path> find_meshes(const std::vector<std::filesystem::path>& inputs);

/// The same for mesh files and label maps. A mesh and a label map may have the same stem, since the label
/// map's shapes have longer ones.
std::vector<std::filesystem::path> find_shape_files(const std::vector<std::filesystem::path>& inputs);
/// The same for label maps alone.
std::vector<std::filesystem::path> find_label_maps(const std::vector<std::filesystem::path>& inputs);

/// Reads and audits each file: meshes in that unit, and of label maps the labels asked for. What cannot be
/// used is left out with its reason; nothing is thrown for one bad file. Throws InvalidInput if two shapes
/// have the same stem, or if a label named singly is in none of the label maps. \param repair  set: what the
/// audit refuses is repaired; surfaces of labels are in any case
Cohort read_cohort(const std::vector<std::filesystem::path>& files, LengthUnit unit, const RunContext& ctx,
                   const LabelRequest& labels = {},
                   const std::optional<RepairOptions>& repair = std::nullopt);

/// The surface as that of a shape whose other members are set; repaired, if that is asked for and needed.
/// Throws InvalidInput with the reason if it cannot be used. Surfaces of files and of labels both come
/// through here.
InputShape usable_shape(InputShape shape, TriangleSoup surface, LengthUnit unit,
                        const std::optional<RepairOptions>& repair = std::nullopt,
                        const RunContext& ctx = RunContext());

/// A raw surface repaired, in mm. Throws InvalidInput as repair_mesh does, and where the size is that of no
/// vertebra in this unit.
RepairedMesh repair_surface(TriangleSoup raw, LengthUnit unit, const RepairOptions& options,
                            const RunContext& ctx);

/// One surface fit for a model, or the reason why not as an InvalidInput or IoError.
InputShape read_shape(const std::filesystem::path& file, LengthUnit unit,
                      const std::optional<RepairOptions>& repair = std::nullopt,
                      const RunContext& ctx = RunContext());

}  // namespace foramen
