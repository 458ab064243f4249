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

/// What is read of a TPS file.
struct TpsFile {
  std::vector<NamedPoints> specimens;
  std::vector<std::string> notes;  ///< what was left out, in words
};

/// Reads the specimens of a TPS file with three coordinates a point (LM3=, or LM=). If all specimens have
/// SCALE=, coordinates are multiplied by it. A specimen without ID= gets the name in IMAGE= without
/// extension, or else "specimenN". Specimens with missing points (NA, or no point at all) and curves are
/// left out, and a note says so. Other KEY=value lines are ignored. Throws IoError with the line:
/// two-dimensional landmarks, SCALE= in only some of the specimens, a name that occurs twice, specimens
/// with different numbers of points, no specimen with all its points.
TpsFile read_tps(const std::filesystem::path& path);

/// Writes a CSV table with the columns shape, landmark (from 0), x, y, z. Throws InvalidInput if there are no
/// specimens, the numbers of points differ or a coordinate is not finite; IoError if the file cannot be
/// written.
void write_landmark_table(const std::filesystem::path& path, std::span<const NamedPoints> shapes);

/// Reads such a table. The rows of a shape must be consecutive and their landmarks count up from 0. Throws
/// IoError with the row.
std::vector<NamedPoints> read_landmark_table(const std::filesystem::path& path);

}  // namespace foramen
