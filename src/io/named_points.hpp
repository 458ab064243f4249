#pragma once
/// \file
/// Corresponding points of several specimens, as TPS files and landmark tables hold them.

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "foramen/core/mesh.hpp"

namespace foramen {

struct NamedPoints {
  std::string name;
  std::vector<Vec3> points;  ///< point i of every specimen is the same landmark
};

/// Writes TPS in the form that readland.tps of geomorph and other readers in R accept: per specimen `LM3=P`,
/// P lines "x y z", `ID=name`. Throws InvalidInput if there are no specimens, the numbers of points differ, a
/// coordinate is not finite, or a name cannot be written to such a file because it contains a line break,
/// '=', or one of the words comment=, curves=, variables, chain, radii and scale: these readers drop lines
/// with such a word. Throws IoError if the file cannot be written.
void write_tps(const std::filesystem::path& path, std::span<const NamedPoints> specimens);

/// Reads the LM3 specimens of a TPS file. If all specimens have SCALE=, coordinates are multiplied by it. A
/// specimen without ID= gets the name in IMAGE= without extension, or else "specimenN". Other KEY=value lines
/// are ignored. Throws IoError with the line: two-dimensional landmarks, curves, missing points (NA), SCALE=
/// in only some of the specimens, a name that occurs twice, specimens with different numbers of points.
std::vector<NamedPoints> read_tps(const std::filesystem::path& path);

/// Writes a CSV table with the columns shape, landmark (from 0), x, y, z. Throws InvalidInput if there are no
/// specimens, the numbers of points differ or a coordinate is not finite; IoError if the file cannot be
/// written.
void write_landmark_table(const std::filesystem::path& path, std::span<const NamedPoints> shapes);

/// Reads such a table. The rows of a shape must be consecutive and their landmarks count up from 0. Throws
/// IoError with the row.
std::vector<NamedPoints> read_landmark_table(const std::filesystem::path& path);

}  // namespace foramen
