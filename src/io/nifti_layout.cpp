// NIfTI-1 in one file, https://nifti.nimh.nih.gov/nifti-1. Not read by ITK, because ITK 5.2 refuses label
// maps whose axes are orthogonal only up to the rounding of the single-precision header.
#include <array>
#include <cmath>
#include <optional>

#include <Eigen/Geometry>

#include "io/segment_names.hpp"
#include "io/voxel_layout.hpp"

namespace foramen::io_detail {
namespace {

constexpr std::int32_t header_bytes = 348, header_bytes_2 = 540;

// The type that a NIfTI type code stands for; nullopt for types that are not one number per voxel.
std::optional<NumberType> type_of(int number) {
  using Kind = NumberKind;
  switch (number) {
    case 2:
      return NumberType{Kind::unsigned_integer, 1};
    case 4:
      return NumberType{Kind::signed_integer, 2};
    case 8:
      return NumberType{Kind::signed_integer, 4};
    case 16:
      return NumberType{Kind::real, 4};
    case 64:
      return NumberType{Kind::real, 8};
    case 256:
      return NumberType{Kind::signed_integer, 1};
    case 512:
      return NumberType{Kind::unsigned_integer, 2};
    case 768:
      return NumberType{Kind::unsigned_integer, 4};
    case 1024:
      return NumberType{Kind::signed_integer, 8};
    case 1280:
      return NumberType{Kind::unsigned_integer, 8};
    default:
      return std::nullopt;
  }
}

class NiftiHeader {
 public:
  explicit NiftiHeader(const Source& source) : source_(source) {
    if (source.bytes.size() < static_cast<std::size_t>(header_bytes))
      source.refuse("has only " + std::to_string(source.bytes.size()) + " bytes, less than a NIfTI header",
                    remedy_export_again);
    order_ = byte_order();
    constexpr std::size_t magic_at = 344;
    if (source.bytes.substr(magic_at, 3) != "n+1")
      source.refuse("has no NIfTI mark in its header",
                    "foramen reads NIfTI in one file (.nii, .nii.gz): convert it");
  }

  VoxelLayout layout() const {
    VoxelLayout layout;
    layout.order = order_;
    layout.size = size();
    constexpr std::size_t type_at = 70, offset_at = 108, slope_at = 112, intercept_at = 116;
    const int number = at<std::int16_t>(type_at);
    const auto type = type_of(number);
    if (!type)
      source_.refuse(
          "its voxels are of NIfTI type " + std::to_string(number) + " (colours, complex or odd numbers)",
          "a label map holds one whole number a voxel");
    layout.type = *type;
    constexpr double farthest = 1e9;
    const double offset = at<float>(offset_at);
    if (!(offset >= header_bytes && offset <= farthest))
      source_.refuse("its header says that the voxels begin at byte " + std::to_string(offset),
                     remedy_export_again);
    layout.skipped = static_cast<std::int64_t>(offset);
    const double slope = at<float>(slope_at), intercept = at<float>(intercept_at);
    if (std::isfinite(slope) && slope != 0 && std::isfinite(intercept)) {
      layout.slope = slope;
      layout.intercept = intercept;
    }
    set_geometry(layout);
    return layout;
  }

 private:
  template <class T>
  T at(std::size_t offset) const {
    return ByteCursor(source_.bytes, offset, order_).template read<T>();
  }

  ByteOrder byte_order() const {
    for (const ByteOrder order : {ByteOrder::little, ByteOrder::big}) {
      const auto size = ByteCursor(source_.bytes, 0, order).read<std::int32_t>();
      if (size == header_bytes_2)
        source_.refuse("is a NIfTI-2 file", "foramen reads NIfTI-1: convert it, or save it as NRRD");
      if (size == header_bytes) return order;
    }
    source_.refuse("does not begin as a NIfTI header does",
                   "it is no NIfTI file: check its format and extension");
  }

  std::array<std::int64_t, 3> size() const {
    constexpr std::size_t dim_at = 40;
    ByteCursor dims(source_.bytes, dim_at, order_);
    const int dimensions = dims.read<std::int16_t>();
    std::array<std::int64_t, 3> size{};
    for (auto& n : size) n = dims.read<std::int16_t>();
    // Some programs write additional dimensions of one element each, or of none.
    bool three = dimensions >= 3 && dimensions <= 7;
    for (int d = 3; three && d < dimensions; ++d) {
      const int length = dims.read<std::int16_t>();
      three = length == 0 || length == 1;
    }
    if (!three)
      source_.refuse("is an image of " + std::to_string(dimensions) + " dimensions",
                     "a label map has three: save one volume of it");
    return size;
  }

  double millimetres_per_unit() const {
    constexpr std::size_t units_at = 123;
    constexpr unsigned space = 7, metre = 1, micrometre = 3;
    const unsigned unit = at<std::uint8_t>(units_at) & space;
    return unit == metre ? 1000 : unit == micrometre ? 0.001 : 1;
  }

  struct Geometry {
    Mat3 axes;
    Vec3 origin;
  };

  // Takes the sform if there is a usable one, else the qform.
  void set_geometry(VoxelLayout& layout) const {
    constexpr std::size_t qform_at = 252, sform_at = 254;
    const bool has_sform = at<std::int16_t>(sform_at) > 0, has_qform = at<std::int16_t>(qform_at) > 0;
    if (!has_sform && !has_qform)
      source_.refuse(
          "does not say how it is oriented (neither sform nor qform), so left and right cannot be told",
          "save it with its orientation");
    Geometry geometry = in_lps(has_sform ? of_matrix() : of_quaternion());
    if (has_sform && has_qform) {
      const Geometry other = in_lps(of_quaternion());
      const auto problem = geometry_problem(geometry.axes, geometry.origin);
      if (problem && !geometry_problem(other.axes, other.origin)) {
        geometry = other;
        layout.notes.push_back("its sform cannot be used (" + problem->found +
                               "); its qform says where it lies");
      }
    }
    layout.axes = geometry.axes;
    layout.origin = geometry.origin;
  }

  // From RAS, in the unit of the file.
  Geometry in_lps(const Geometry& ras) const {
    const Mat3 lps_from_ras = millimetres_per_unit() * Vec3(-1, -1, 1).asDiagonal().toDenseMatrix();
    return {lps_from_ras * ras.axes, lps_from_ras * ras.origin};
  }

  Geometry of_matrix() const {
    constexpr std::size_t rows_at = 280;
    ByteCursor rows(source_.bytes, rows_at, order_);
    Geometry geometry;
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) geometry.axes(r, c) = rows.read<float>();
      geometry.origin[r] = rows.read<float>();
    }
    return geometry;
  }

  Geometry of_quaternion() const {
    constexpr std::size_t pixdim_at = 76, quaternion_at = 256;
    ByteCursor sizes(source_.bytes, pixdim_at, order_), values(source_.bytes, quaternion_at, order_);
    const double handedness = sizes.read<float>() < 0 ? -1 : 1;
    Vec3 spacing;
    for (double& s : spacing) s = sizes.read<float>();
    spacing.z() *= handedness;
    const double b = values.read<float>(), c = values.read<float>(), d = values.read<float>();
    const double a = std::sqrt(std::max(0.0, 1 - (b * b + c * c + d * d)));
    Geometry geometry;
    geometry.axes = Eigen::Quaterniond(a, b, c, d).normalized().toRotationMatrix() * spacing.asDiagonal();
    for (double& o : geometry.origin) o = values.read<float>();
    return geometry;
  }

  const Source& source_;
  ByteOrder order_ = ByteOrder::little;
};

// What stands between the header and the voxels, without the four bytes that announce it; empty if there is
// nothing, or more than a table of labels needs.
std::string extensions_of(const std::filesystem::path& path, ByteStream::Packing packing,
                          std::int64_t voxels_at) {
  constexpr std::int64_t first = header_bytes + 4, longest = 1 << 20;
  if (voxels_at <= first || voxels_at > longest) return {};
  std::string bytes(voxels_at, '\0');
  bytes.resize(ByteStream(path, 0, packing).read(bytes.data(), bytes.size()));
  if (std::ssize(bytes) < voxels_at || bytes[header_bytes] == 0) return {};
  return bytes.substr(first);
}

}  // namespace

VoxelLayout nifti_layout(const std::filesystem::path& path) {
  require_readable(path);
  VoxelLayout whole;
  whole.data_files = {path};
  set_packing_by_content(whole);
  std::string header(header_bytes, '\0');
  header.resize(ByteStream(path, 0, whole.packing).read(header.data(), header.size()));
  const Source source{path.string(), header};
  VoxelLayout layout = NiftiHeader(source).layout();
  layout.names = {
      names_in_extensions(source, extensions_of(path, whole.packing, layout.skipped), layout.order)};
  layout.data_files = whole.data_files;
  layout.packing = whole.packing;
  return layout;
}

}  // namespace foramen::io_detail
