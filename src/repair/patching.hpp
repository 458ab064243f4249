#pragma once
// Removal of triangles from a mesh and filling of holes by disks.

#include <optional>
#include <vector>

#include "repair/fairing.hpp"

namespace foramen::repair_detail {

/// A mesh after a change, with the origin of its vertices.
struct EditedMesh {
  Mesh mesh;
  VertexMap<VertexId> origin;  ///< per vertex: its index before the change; invalid for a new vertex
};

EditedMesh unchanged(const Mesh& mesh);
/// The origins over two successive changes.
VertexMap<VertexId> composed(const VertexMap<VertexId>& first, const VertexMap<VertexId>& second);

using FaceSet = FaceMap<char>;  // 1: in the set

/// All faces that have a vertex in common with a face of the set.
FaceSet grown(const Mesh& mesh, const FaceSet& faces);
/// All faces at the vertices of the walk.
FaceSet faces_along(const Mesh& mesh, const std::vector<HalfedgeId>& walk);

/// The mesh without these faces. The set is enlarged until the remaining mesh is a connected manifold: by all
/// faces at a vertex where it would touch itself, and by all its pieces except the largest. nullopt if no
/// face would be left. \pre closed
std::optional<EditedMesh> without_faces(const Mesh& mesh, FaceSet faces);

/// A closed loop of boundary halfedges, in their direction.
using Border = std::vector<HalfedgeId>;
/// All borders of the mesh, in the order of their first halfedges.
std::vector<Border> borders(const Mesh& mesh);
double border_length(const Mesh& mesh, const Border& border);
Vec3 border_centre(const Mesh& mesh, const Border& border);

/// Closes each border by a disk. Old vertices and faces keep their indices. New ones come last, and new
/// vertices are faired. \pre no border has more than most_loop_points vertices
Mesh with_disks(const Mesh& open, Fairness fairness);

}  // namespace foramen::repair_detail
