#pragma once
/// \file
/// Points and curves that people marked on shapes: markups of 3D Slicer (.mrk.json, .fcsv), landmarks of
/// Scalismo (.json) and tables (.csv).

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "foramen/core/marks.hpp"
#include "foramen/io/mesh_file.hpp"

namespace foramen {

/// The marks that a file holds of one shape.
struct NamedMarks {
  std::string shape;   ///< empty: the file does not name it
  MarksOfShape marks;  ///< a name is empty if the file does not give it
};

/// The content of a file of marks.
struct MarkFile {
  std::vector<NamedMarks> shapes;
  std::optional<AnatomicalSpace> space;  ///< unset: the coordinates are those of the shape's own file
};

/// Whether the file name ends with .json, .fcsv or .csv, in upper or lower case.
bool is_mark_file(const std::filesystem::path& path);

/// The file name without its extension, for .mrk.json without both.
std::string mark_stem(const std::filesystem::path& path);

/// Reads a file of marks:
///
/// - .mrk.json of Slicer: the points of a Fiducial list or an Angle are single points, named by their labels.
///   A Line or Curve is an open curve and a ClosedCurve a closed one, through its control points. A curve's
///   name is its own or the common part of its labels ("rim" of "rim-1", "rim-2"). Points that are not placed
///   are passed over.
/// - .fcsv of Slicer: single points, named by their labels.
/// - .json of Scalismo: single points, named by their ids.
/// - .csv: a row a point with the columns landmark, x, y, z and, optionally, shape, kind (point, open or
///   closed) and index, by which the points of a curve are ordered. Without a kind, each row is a point.
///
/// Throws IoError with the file, what was found and what to do.
MarkFile read_mark_file(const std::filesystem::path& path);

}  // namespace foramen
