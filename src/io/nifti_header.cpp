#include "io/nifti_header.hpp"

#include <string>
#include <string_view>

namespace foramen::io_detail {
namespace {

// One version of the format: its number types and where its fields begin.
struct Version1 {
  using Integer = std::int16_t;
  using Real = float;
  using Offset = float;
  using Code = std::int16_t;
  using Units = std::uint8_t;
  static constexpr std::int32_t bytes = 348;
  static constexpr std::string_view mark = "n+1";
  static constexpr std::size_t mark_at = 344, dim_at = 40, type_at = 70, pixdim_at = 76, voxels_at = 108,
                               slope_at = 112, intercept_at = 116, units_at = 123, qform_at = 252,
                               sform_at = 254, quaternion_at = 256, matrix_at = 280;
};
struct Version2 {
  using Integer = std::int64_t;
  using Real = double;
  using Offset = std::int64_t;
  using Code = std::int32_t;
  using Units = std::int32_t;
  static constexpr std::int32_t bytes = 540;
  static constexpr std::string_view mark = "n+2";
  static constexpr std::size_t mark_at = 4, dim_at = 16, type_at = 12, pixdim_at = 104, voxels_at = 168,
                               slope_at = 176, intercept_at = 184, units_at = 500, qform_at = 344,
                               sform_at = 348, quaternion_at = 352, matrix_at = 400;
};

template <class Version>
NiftiHeader read_header(const Source& source, ByteOrder order) {
  if (source.bytes.size() < static_cast<std::size_t>(Version::bytes))
    source.refuse("has only " + std::to_string(source.bytes.size()) + " bytes, less than a NIfTI header",
                  remedy_export_again);
  if (source.bytes.substr(Version::mark_at, Version::mark.size()) != Version::mark)
    source.refuse("has no NIfTI mark in its header",
                  "foramen reads NIfTI in one file (.nii, .nii.gz): convert it");
  const auto at = [&](std::size_t offset) { return ByteCursor(source.bytes, offset, order); };
  using Real = typename Version::Real;
  NiftiHeader header;
  header.order = order;
  header.bytes = Version::bytes;
  ByteCursor dim = at(Version::dim_at), pixdim = at(Version::pixdim_at),
             quaternion = at(Version::quaternion_at), matrix = at(Version::matrix_at);
  for (auto& n : header.dim) n = dim.template read<typename Version::Integer>();
  header.type = at(Version::type_at).template read<std::int16_t>();
  for (double& edge : header.pixdim) edge = pixdim.template read<Real>();
  header.voxels_at = static_cast<double>(at(Version::voxels_at).template read<typename Version::Offset>());
  header.slope = at(Version::slope_at).template read<Real>();
  header.intercept = at(Version::intercept_at).template read<Real>();
  header.units = at(Version::units_at).template read<typename Version::Units>();
  header.qform_code = at(Version::qform_at).template read<typename Version::Code>();
  header.sform_code = at(Version::sform_at).template read<typename Version::Code>();
  for (double& q : header.quaternion) q = quaternion.template read<Real>();
  for (double& o : header.quaternion_offset) o = quaternion.template read<Real>();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) header.matrix(row, column) = matrix.template read<Real>();
    header.matrix_offset[row] = matrix.template read<Real>();
  }
  return header;
}

}  // namespace

NiftiHeader nifti_header(const Source& source) {
  if (source.bytes.size() < static_cast<std::size_t>(Version1::bytes))
    source.refuse("has only " + std::to_string(source.bytes.size()) + " bytes, less than a NIfTI header",
                  remedy_export_again);
  for (const ByteOrder order : {ByteOrder::little, ByteOrder::big}) {
    const auto bytes = ByteCursor(source.bytes, 0, order).read<std::int32_t>();
    if (bytes == Version1::bytes) return read_header<Version1>(source, order);
    if (bytes == Version2::bytes) return read_header<Version2>(source, order);
  }
  source.refuse("does not begin as a NIfTI header does",
                "it is no NIfTI file: check its format and extension");
}

}  // namespace foramen::io_detail
