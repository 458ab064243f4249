#pragma once
/// \file
/// Private to io: files of other kinds that people give instead of a surface or a label map.

#include <filesystem>

#include "io/file_bytes.hpp"

namespace foramen::io_detail {

/// Throws IoError if the first bytes are those of a well-known kind that foramen does not read (DICOM,
/// archives, pictures, CAD, MATLAB ...). The message names the kind and how to convert it.
void refuse_foreign(const Source& source);
/// The same for a file of which only the beginning is read.
void refuse_foreign(const std::filesystem::path& path);

}  // namespace foramen::io_detail
