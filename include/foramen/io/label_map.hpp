#pragma once
/// \file
/// Label maps on disk: NIfTI-1, NRRD and MetaImage.

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "foramen/core/mesh.hpp"
#include "foramen/core/remedy.hpp"

namespace foramen {

/// A label map: an integer label for every voxel of a rectangular lattice; 0 is the background.
struct LabelMap {
  std::array<int, 3> size{};          ///< voxels along i, j, k; each > 0
  std::vector<std::uint16_t> labels;  ///< voxel (i, j, k) is at (k * size[1] + j) * size[0] + i
  Mat3 axes = Mat3::Identity();  ///< columns: the step to the next voxel along i, j, k, LPS mm; orthogonal
  Vec3 origin = Vec3::Zero();    ///< centre of voxel (0, 0, 0), LPS mm
  /// Of the file's bytes; if header and data are several files, of the header followed by the data.
  std::string sha256;
  std::vector<Message> notes;  ///< what was amiss in the file and how it was taken; mostly empty
  /// What the file itself calls its labels, e.g. "L1 vertebra"; empty if it names none.
  std::map<int, std::string> names = {};

  std::uint16_t at(int i, int j, int k) const {
    return labels[(static_cast<std::size_t>(k) * static_cast<std::size_t>(size[1]) +
                   static_cast<std::size_t>(j)) *
                      static_cast<std::size_t>(size[0]) +
                  static_cast<std::size_t>(i)];
  }
};

/// Whether the file name ends with one of label_map_extensions(), in upper or lower case.
bool is_label_map(const std::filesystem::path& path);
/// .seg.nrrd .nii .nii.gz .nrrd .nhdr .mha .mhd
const std::vector<std::string>& label_map_extensions();
/// The file name without its label-map extension.
std::string label_map_stem(const std::filesystem::path& path);

/// Reads one three-dimensional image of labels 0 .. 65535, stored as integers or floating-point numbers, in
/// any orientation; further axes of length 1 are passed over. Values that became fractions on the way
/// (19.9999) are rounded, up to 0.05. A NIfTI file is placed by its sform if that is usable, else by its
/// qform. NRRD may be in LPS, RAS or LAS space; MetaImage is in LPS. Whether data are compressed is seen by
/// their first bytes, not by the name. Data in several files are read if these lie in the folder of the
/// header or below. Memory is allocated for the data that the file holds, not for the size that its header
/// states.
///
/// Throws IoError with the file, what was found and what to do: a header that states more data than the file
/// holds, a truncated or damaged file, another kind of file, a number of dimensions other than three, colours
/// or vectors, axes that are not at right angles, no orientation, or values that are no labels (fractions and
/// negative numbers, as in a grey-value image).
///
/// Names of labels come from the segments of 3D Slicer (.seg.nrrd) and from a table of labels in a header
/// extension of NIfTI, as TotalSegmentator and Connectome Workbench write it. An extension that cannot be
/// read names nothing.
LabelMap read_label_map(const std::filesystem::path& path);

/// As read_label_map(), but also reads the layers in which 3D Slicer saves segments that overlap (NRRD of
/// four dimensions). Each layer is a label map of its own, with the names of its own segments, and two layers
/// may use the same label for different segments. All other files have one layer.
std::vector<LabelMap> read_label_layers(const std::filesystem::path& path);

}  // namespace foramen
