#pragma once
// Taking triangles out of a mesh, and closing what is open by disks.

#include <optional>
#include <vector>

#include "repair/fairing.hpp"

namespace foramen::repair_detail {

/// A mesh after a change, and the way back.
struct EditedMesh {
  Mesh mesh;
  VertexMap<VertexId> origin;  ///< per vertex: the vertex before; invalid: new
};

EditedMesh unchanged(const Mesh& mesh);
/// The way back over two changes, the second made on the result of the first.
VertexMap<VertexId> composed(const VertexMap<VertexId>& first, const VertexMap<VertexId>& second);

using FaceSet = FaceMap<char>;  // 1: in the set

/// The faces at vertices of the set.
FaceSet grown(const Mesh& mesh, const FaceSet& faces);
/// The faces round a vertex of the walk.
FaceSet faces_along(const Mesh& mesh, const std::vector<HalfedgeId>& walk);

/// The mesh without these faces. The set is enlarged until what is left is a manifold in one piece: by the
/// faces round a vertex where the rest would touch itself, and by all pieces but the largest. Empty if
/// nothing would be left. \pre closed
std::optional<EditedMesh> without_faces(const Mesh& mesh, FaceSet faces);

/// A closed loop of boundary halfedges, in their direction.
using Border = std::vector<HalfedgeId>;
/// In the order of their first halfedges.
std::vector<Border> borders(const Mesh& mesh);
double border_length(const Mesh& mesh, const Border& border);
Vec3 border_centre(const Mesh& mesh, const Border& border);

/// A disk in each border. Old vertices and faces keep their numbers, new ones come last; their positions are
/// fair. \pre no border has more than most_loop_points vertices
Mesh with_disks(const Mesh& open, Fairness fairness);

}  // namespace foramen::repair_detail
