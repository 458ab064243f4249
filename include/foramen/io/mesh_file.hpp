#pragma once
/// \file
/// Surfaces on disk: PLY, STL, OBJ, OFF, legacy VTK and VTP. The readers take what common programs write and
/// pass over what does not belong to the surface. They refuse damaged, incomplete and contradictory files.

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "foramen/core/mesh.hpp"
#include "foramen/core/remedy.hpp"
#include "foramen/core/units.hpp"

namespace foramen {

/// Axes of the coordinates: LPS (left, posterior, superior; DICOM, ITK) or RAS (right, anterior, superior).
enum class AnatomicalSpace { lps, ras };

/// The content of a mesh file.
struct MeshFile {
  TriangleSoup soup;
  std::optional<AnatomicalSpace>
      space;                   ///< from a SPACE=LPS / SPACE=RAS comment; unset: untagged (taken as LPS)
  std::vector<Message> notes;  ///< what was changed or passed over; mostly empty
};

/// The extensions (lower case, with dot) that read_mesh() reads.
const std::vector<std::string>& mesh_extensions();

/// Whether the file name ends with one of mesh_extensions(), in upper or lower case, or with .gz after it.
bool is_mesh_file(const std::filesystem::path& path);
/// The file name without its extension, and without .gz after that.
std::string mesh_stem(const std::filesystem::path& path);

/// Reads a mesh in the format that the extension (upper or lower case) names. A file that gzip packed is
/// unpacked, whatever its name, up to 2 GiB. Polygons and strips become triangles, loose points and lines are
/// passed over, and a note says so. STL corners with exactly equal coordinates become one vertex. Throws
/// IoError with the file, what was found, where in the file, and what to do.
MeshFile read_mesh(const std::filesystem::path& path);

/// A scalar field on the vertices, one value per point; the name has no blanks.
struct VertexScalar {
  std::string name;
  std::vector<double> values;
};

/// Writes binary little-endian PLY with float32 coordinates, the list property `vertex_indices`, LF line ends
/// and one comment SPACE=LPS or SPACE=RAS. Throws InvalidInput if a coordinate is not finite in float32 or a
/// corner does not exist; IoError if the file cannot be written.
void write_ply(const std::filesystem::path& path, const TriangleSoup& soup,
               AnatomicalSpace space = AnatomicalSpace::lps);

/// The same with scalar fields as float32 vertex properties after the coordinates. Viewers can colour by them
/// and other readers skip them. Throws InvalidInput also for a field that has not exactly one value per
/// point.
void write_ply(const std::filesystem::path& path, const TriangleSoup& soup, AnatomicalSpace space,
               std::span<const VertexScalar> scalars);

/// Writes VTK XML PolyData with inline base64 binary arrays and a field SPACE. Throws as write_ply(). Does
/// not need the VTK library.
void write_vtp(const std::filesystem::path& path, const TriangleSoup& soup,
               AnatomicalSpace space = AnatomicalSpace::lps);

}  // namespace foramen
