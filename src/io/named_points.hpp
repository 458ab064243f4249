#pragma once
/// \file
/// Corresponding points of several specimens: what TPS files and tables of landmarks hold.

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

/// TPS, as geomorph's readland.tps and other readers of R take it: per specimen `LM3=P`, P
/// lines "x y z", `ID=name`. Throws InvalidInput if there are none, the numbers of points differ, a number is
/// not finite, or a name cannot stand in such a file: a line break, '=', or one of the words comment=,
/// curves=, variables, chain, radii and scale, of which readers drop the line.
void write_tps(const std::filesystem::path& path, std::span<const NamedPoints> specimens);

/// Reads LM3 specimens. Coordinates are multiplied by SCALE= where all specimens have one. Specimens without
/// ID= are named by IMAGE= without extension, or "specimenN". Other KEY=value lines are passed over. Throws
/// IoError naming the line: two-dimensional landmarks, curves, missing points (NA), SCALE= of some specimens
/// only, names that come twice, specimens with other numbers of points.
std::vector<NamedPoints> read_tps(const std::filesystem::path& path);

/// A table with the columns shape, landmark (from 0), x, y, z. Throws InvalidInput as above, IoError.
void write_landmark_table(const std::filesystem::path& path, std::span<const NamedPoints> shapes);

/// The same read back: rows of a shape stand together, landmarks count up from 0. Throws IoError naming the
/// row.
std::vector<NamedPoints> read_landmark_table(const std::filesystem::path& path);

}  // namespace foramen
