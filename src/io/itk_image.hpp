#pragma once
/// \file
/// Private to io: images through ITK. ITK has an Eigen of its own, so no header of ours that includes Eigen may
/// meet ITK's: plain types only.

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace foramen::io_detail {

enum class ImageFormat { nifti, nrrd, meta };

struct ItkImage {
  std::vector<std::uint16_t> labels;
  std::array<std::array<double, 3>, 3> direction{};  ///< direction[d]: unit vector of axis d, LPS
  std::array<double, 3> spacing{}, origin{};         ///< mm, LPS
};

/// Reads an image whose header has been checked and promises this size. Throws IoError: ITK refuses, or finds
/// other than that; a value that is no label.
ItkImage read_with_itk(const std::filesystem::path& path, ImageFormat format,
                       const std::array<std::int64_t, 3>& size);

}  // namespace foramen::io_detail
