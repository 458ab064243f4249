#pragma once
/// \file
/// Labels of the vertices of a surface: text, or scalars of a mesh file.

#include <filesystem>
#include <vector>

namespace foramen {

/// Whether the file name ends with .txt, .ply, .vtk or .vtp, in upper or lower case.
bool is_label_list(const std::filesystem::path& path);

/// Reads a whole number a vertex: from a text file one a line, from a PLY file a property of its vertices,
/// from VTK a scalar of its points. Of several, the one that is called label, labels, region, regions,
/// segment or scalars counts. Colours, normals and texture coordinates are no labels. Throws IoError with
/// the file, what was found and what to do.
std::vector<int> read_vertex_labels(const std::filesystem::path& path);

}  // namespace foramen
