#pragma once
/// \file
/// Files of ShapeWorks: projects (.swproj, .xlsx) and particles (.particles).

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "foramen/core/mesh.hpp"

namespace foramen {

/// Writes particles in order, one line "x y z" each. The last line ends with a line end too, because
/// ShapeWorks drops it otherwise. Throws InvalidInput if there are no particles or one is not finite; IoError
/// if the file cannot be written.
void write_particles(const std::filesystem::path& path, std::span<const Vec3> particles);

/// Throws IoError with the line at fault.
std::vector<Vec3> read_particles(const std::filesystem::path& path);

/// One shape of a project. Paths are relative to the folder of the project; an empty path means no file.
struct ShapeWorksSubject {
  std::string name;
  std::filesystem::path shape;            ///< the original surface
  std::filesystem::path groomed;          ///< the surface on which ShapeWorks optimised the particles
  std::filesystem::path local_particles;  ///< in the coordinates of the groomed file
  std::filesystem::path world_particles;  ///< in common coordinates
  Eigen::Matrix4d alignment = Eigen::Matrix4d::Identity();
  Eigen::Matrix4d procrustes = Eigen::Matrix4d::Identity();  ///< world = procrustes * alignment * local
};

/// Writes a project of one domain, named "1". All values are texts, because ShapeWorks reads nothing else.
/// Throws InvalidInput if a name is not UTF-8; IoError if the file cannot be written.
/// \param particles  number of particles per shape
void write_shapeworks(const std::filesystem::path& path, std::span<const ShapeWorksSubject> subjects,
                      std::size_t particles);

/// Reads a project of one domain of any name, as JSON or as a spreadsheet. A subject without a name gets
/// the name of its shape file or particle file. A missing transform is the identity; one of twelve numbers
/// (older projects) is a translation. Throws IoError with the subject: several domains, a value that is not
/// a text, an invalid transform. Does not check whether the files exist.
std::vector<ShapeWorksSubject> read_shapeworks(const std::filesystem::path& path);

}  // namespace foramen
