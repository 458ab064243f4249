#pragma once
/// \file
/// Triangle meshes on disk: PLY, STL, OBJ, OFF, legacy VTK and VTP, by our own strict readers.

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "foramen/core/mesh.hpp"
#include "foramen/core/units.hpp"

namespace foramen {

/// Axes of the coordinates: LPS (left, posterior, superior; DICOM, ITK) or RAS (right, anterior, superior).
enum class AnatomicalSpace { lps, ras };

/// What a mesh file says.
struct MeshFile {
  TriangleSoup soup;
  std::optional<AnatomicalSpace>
      space;  ///< from a SPACE=LPS / SPACE=RAS comment; unset: untagged (taken as LPS)
};

/// Extensions (lower case, with dot) that read_mesh understands.
const std::vector<std::string>& mesh_extensions();

/// Reads by extension (any case). Polygons with more than three corners are refused. STL corners with the
/// very same coordinates are welded. Throws IoError naming the file, what was found, where, and what to do.
MeshFile read_mesh(const std::filesystem::path& path);

/// A number for every point, by a name without blanks.
struct VertexScalar {
  std::string name;
  std::vector<double> values;
};

/// Binary little-endian PLY: float32 coordinates, `vertex_indices`, LF line ends, one SPACE comment
/// (INTEROP 3.6).
void write_ply(const std::filesystem::path& path, const TriangleSoup& soup,
               AnatomicalSpace space = AnatomicalSpace::lps);

/// The same with scalars as float32 properties of the vertices, after the coordinates: viewers colour by
/// them, other readers pass over them. Throws InvalidInput for a scalar that has not one value per point.
void write_ply(const std::filesystem::path& path, const TriangleSoup& soup, AnatomicalSpace space,
               std::span<const VertexScalar> scalars);

/// VTK XML PolyData (ASCII-free appended-free inline base64 binary), with a SPACE field. Needs no VTK.
void write_vtp(const std::filesystem::path& path, const TriangleSoup& soup,
               AnatomicalSpace space = AnatomicalSpace::lps);

}  // namespace foramen
