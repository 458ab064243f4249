#pragma once
/// \file
/// Private to io: the fields of a NIfTI header that a label map needs, of both versions of the format,
/// https://nifti.nimh.nih.gov/nifti-1 and https://nifti.nimh.nih.gov/nifti-2.

#include <array>
#include <cstdint>

#include "foramen/core/geometry.hpp"
#include "io/file_bytes.hpp"

namespace foramen::io_detail {

struct NiftiHeader {
  ByteOrder order = ByteOrder::little;
  std::int64_t bytes = 0;                 ///< length of the header: 348 or 540
  std::array<std::int64_t, 8> dim{};      ///< the number of dimensions, then the size along each
  int type = 0;                           ///< code of the number type
  double voxels_at = 0;                   ///< where the voxels begin, bytes
  double slope = 0, intercept = 0;        ///< value = slope * stored value + intercept, unless slope is 0
  int units = 0;                          ///< code of the unit of lengths and times
  int qform_code = 0, sform_code = 0;     ///< above 0: the transform is set
  std::array<double, 4> pixdim{};         ///< handedness of the qform (below 0: left), then the voxel's edges
  Vec3 quaternion = Vec3::Zero();         ///< b, c, d of the qform's rotation
  Vec3 quaternion_offset = Vec3::Zero();  ///< centre of the first voxel by the qform
  Mat3 matrix = Mat3::Zero();             ///< the sform: columns are the steps along i, j, k
  Vec3 matrix_offset = Vec3::Zero();      ///< centre of the first voxel by the sform
};

/// As many bytes as the longer of the two headers has.
constexpr std::int64_t longest_nifti_header = 540;

/// Reads the header from the first bytes of a file. Throws IoError if they are none, or the voxels are in
/// another file.
NiftiHeader nifti_header(const Source& source);

}  // namespace foramen::io_detail
