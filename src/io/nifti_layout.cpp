// NIfTI-1 and NIfTI-2 in one file. Not read by ITK, because ITK 5.2 refuses label
// maps whose axes are orthogonal only up to the rounding of the single-precision header.
#include <array>
#include <cmath>
#include <optional>

#include <Eigen/Geometry>

#include "io/nifti_header.hpp"
#include "io/segment_names.hpp"
#include "io/voxel_layout.hpp"

namespace foramen::io_detail {
namespace {

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

// A label map's layout by its header.
class LayoutOfHeader {
 public:
  LayoutOfHeader(const Source& source, const NiftiHeader& header) : source_(source), header_(header) {}

  VoxelLayout layout() const {
    VoxelLayout layout;
    layout.order = header_.order;
    layout.size = size();
    const auto type = type_of(header_.type);
    if (!type)
      source_.refuse("its voxels are of NIfTI type " + std::to_string(header_.type) +
                         " (colours, complex or odd numbers)",
                     "a label map holds one whole number a voxel");
    layout.type = *type;
    constexpr double farthest = 1e9;
    if (!(header_.voxels_at >= static_cast<double>(header_.bytes) && header_.voxels_at <= farthest))
      source_.refuse("its header says that the voxels begin at byte " + std::to_string(header_.voxels_at),
                     remedy_export_again);
    layout.skipped = static_cast<std::int64_t>(header_.voxels_at);
    if (std::isfinite(header_.slope) && header_.slope != 0 && std::isfinite(header_.intercept)) {
      layout.slope = header_.slope;
      layout.intercept = header_.intercept;
    }
    set_geometry(layout);
    return layout;
  }

 private:
  std::array<std::int64_t, 3> size() const {
    const std::int64_t dimensions = header_.dim[0];
    // Some programs write additional dimensions of one element each, or of none.
    bool three = dimensions >= 3 && dimensions <= 7;
    for (std::int64_t d = 4; three && d <= dimensions; ++d)
      three = header_.dim[d] == 0 || header_.dim[d] == 1;
    if (!three)
      source_.refuse("is an image of " + std::to_string(dimensions) + " dimensions",
                     "a label map has three: save one volume of it");
    return {header_.dim[1], header_.dim[2], header_.dim[3]};
  }

  double millimetres_per_unit() const {
    constexpr int space = 7, metre = 1, micrometre = 3;
    const int unit = header_.units & space;
    return unit == metre ? 1000 : unit == micrometre ? 0.001 : 1;
  }

  struct Geometry {
    Mat3 axes;
    Vec3 origin;
  };

  // Takes the sform if there is a usable one, else the qform.
  void set_geometry(VoxelLayout& layout) const {
    const bool has_sform = header_.sform_code > 0, has_qform = header_.qform_code > 0;
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

  Geometry of_matrix() const { return {header_.matrix, header_.matrix_offset}; }

  Geometry of_quaternion() const {
    const double handedness = header_.pixdim[0] < 0 ? -1 : 1;
    const Vec3 spacing(header_.pixdim[1], header_.pixdim[2], header_.pixdim[3] * handedness);
    const Vec3& q = header_.quaternion;
    const double a = std::sqrt(std::max(0.0, 1 - q.squaredNorm()));
    const Mat3 rotation = Eigen::Quaterniond(a, q.x(), q.y(), q.z()).normalized().toRotationMatrix();
    return {rotation * spacing.asDiagonal(), header_.quaternion_offset};
  }

  const Source& source_;
  const NiftiHeader& header_;
};

// What stands between the header and the voxels, without the four bytes that announce it; empty if there is
// nothing, or more than a table of labels needs.
std::string extensions_of(const std::filesystem::path& path, ByteStream::Packing packing,
                          std::int64_t header_bytes, std::int64_t voxels_at) {
  constexpr std::int64_t longest = 1 << 20;
  const std::int64_t first = header_bytes + 4;
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
  std::string bytes(longest_nifti_header, '\0');
  bytes.resize(ByteStream(path, 0, whole.packing).read(bytes.data(), bytes.size()));
  const Source source{path.string(), bytes};
  const NiftiHeader header = nifti_header(source);
  VoxelLayout layout = LayoutOfHeader(source, header).layout();
  layout.names = {names_in_extensions(
      source, extensions_of(path, whole.packing, header.bytes, layout.skipped), layout.order)};
  layout.data_files = whole.data_files;
  layout.packing = whole.packing;
  return layout;
}

}  // namespace foramen::io_detail
