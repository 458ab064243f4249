#pragma once
/// \file
/// ShapeWorks: projects (.swproj) and particles (.particles).

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "foramen/core/mesh.hpp"

namespace foramen {

/// Particles in order, one a line, "x y z"; a line end after the last, without which ShapeWorks drops it.
/// Throws InvalidInput if there are none or one is not finite; IoError.
void write_particles(const std::filesystem::path& path, std::span<const Vec3> particles);

/// Throws IoError naming the line.
std::vector<Vec3> read_particles(const std::filesystem::path& path);

/// One shape of a project. Files by their paths from the project's folder; empty: none.
struct ShapeWorksSubject {
  std::string name;
  std::filesystem::path shape;            ///< as it came
  std::filesystem::path groomed;          ///< as it was given to the optimisation
  std::filesystem::path local_particles;  ///< in the groomed file's coordinates
  std::filesystem::path world_particles;  ///< in common coordinates
  Eigen::Matrix4d alignment = Eigen::Matrix4d::Identity();
  Eigen::Matrix4d procrustes = Eigen::Matrix4d::Identity();  ///< world = procrustes * alignment * local
};

/// A project of one domain, named "1", with `particles` a shape. Every value is a text, since ShapeWorks
/// reads nothing else. Throws InvalidInput if a name is not UTF-8; IoError.
void write_shapeworks(const std::filesystem::path& path, std::span<const ShapeWorksSubject> subjects,
                      std::size_t particles);

/// Reads projects of one domain, whatever its name. Subjects without a name get that of their shape's or
/// particles' file. A transform that is not there is the identity; one of twelve numbers (older projects) is
/// a translation. Throws IoError naming the subject: several domains, values that are no text, a transform
/// that is none. Whether the files exist is not looked at.
std::vector<ShapeWorksSubject> read_shapeworks(const std::filesystem::path& path);

}  // namespace foramen
