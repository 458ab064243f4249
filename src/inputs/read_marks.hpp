#pragma once
/// \file
/// Marks and regions of a cohort's shapes, from the files that people made.

#include <filesystem>
#include <string>
#include <vector>

#include "foramen/core/marks.hpp"
#include "foramen/core/remedy.hpp"
#include "foramen/core/units.hpp"
#include "foramen/io/mesh_file.hpp"

namespace foramen {

/// The shapes that are marked.
struct MarkedShapes {
  std::vector<std::string> names;
  std::vector<AnatomicalSpace> spaces;  ///< axes of the coordinates of each shape's surface
  std::vector<Mesh> surfaces = {};      ///< mm; regions that are given as voxels need them
};

struct ReadMarks {
  std::vector<MarksOfShape> marks;  ///< one per shape, in its coordinates, mm; empty for one without marks
  std::vector<Message> notes;       ///< what was passed over
};

/// Reads files of marks, see read_mark_file(). A folder stands for those in it and in its subfolders. A table
/// names its shapes; any other file is of the shape that shape_of_file() says, and a curve without a name
/// has what the file's name adds to that of the shape. Coordinates are turned from the file's axes to the
/// shape's. Marks of other shapes are passed over with a note.
///
/// Throws InvalidInput if there is no such file, no shape has marks, or a mark has no name.
ReadMarks read_marks(const std::vector<std::filesystem::path>& inputs, const MarkedShapes& shapes,
                     const InputUnit& unit);

struct ReadRegions {
  std::vector<RegionsOfShape> regions;  ///< one per shape; without names for one without regions
  std::vector<Message> notes;
};

/// Reads files with a label a vertex (read_vertex_labels()) and label maps (voxel_regions()). A label is the
/// name of its region; 0 and less is no region. Files are found and belong to shapes as those of marks.
ReadRegions read_regions(const std::vector<std::filesystem::path>& inputs, const MarkedShapes& shapes);

}  // namespace foramen
