#pragma once
/// \file
/// Private to io: one parser per mesh format. All of them work on the bytes in memory.

#include <filesystem>

#include "foramen/io/mesh_file.hpp"
#include "io/soup_builder.hpp"

namespace foramen::io_detail {

MeshFile parse_ply(const Source& source);
MeshFile parse_stl(const Source& source);
MeshFile parse_obj(const Source& source);
MeshFile parse_off(const Source& source);
/// Legacy VTK: PolyData, and unstructured grids whose cells are those of a surface.
MeshFile parse_vtk(const Source& source);

/// VTK XML PolyData: text, inline or appended binary, with or without compression.
MeshFile parse_vtp(const Source& source);

/// The numbers of the vertices beyond their coordinates, each with the name that the file gives it. Fields of
/// several numbers a vertex are passed over.
std::vector<VertexScalar> parse_ply_scalars(const Source& source);
std::vector<VertexScalar> parse_vtk_scalars(const Source& source);
std::vector<VertexScalar> parse_vtp_scalars(const Source& source);

/// Throws InvalidInput unless every coordinate is finite in float32 and every corner exists.
void check_writable(const std::filesystem::path& path, const TriangleSoup& soup);

}  // namespace foramen::io_detail
