#pragma once
/// \file
/// Private to io: the numbers of a DataArray in VTK XML files, in any of the encodings of VTK.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/unpack_block.hpp"
#include "io/xml_elements.hpp"

namespace foramen::io_detail {

/// Reads the arrays of one file: as text, as base64 within the element, or from the data appended at the end
/// of the file, raw or in base64. Blocks compressed by zlib, LZ4 or LZMA are decompressed. Throws IoError for
/// an array that is missing, damaged, of another type or compressed by another method. Memory is allocated
/// only for sizes that the file can hold.
class VtkDataArrays {
 public:
  /// \param file  the root element
  /// \param appended  the data after the mark '_' of AppendedData; empty if there are none
  /// \param appended_base64  whether these data are in base64
  VtkDataArrays(const Source& source, const XmlElement& file, std::string_view appended,
                bool appended_base64);

  /// The array of that name among the children of an element; for an element Points its only array.
  const XmlElement& find(const XmlElement& parent, const std::string& name) const;
  std::vector<double> numbers(const XmlElement& array) const;
  /// Refuses an array of floating point numbers.
  std::vector<std::int64_t> integers(const XmlElement& array) const;
  /// Decodes an array of character codes up to the first NUL.
  std::string text(const XmlElement& array) const;

 private:
  class Run;
  std::string bytes(const XmlElement& array) const;
  std::string unpacked(Run run) const;
  std::string inflated(Run& run) const;
  template <class Value>
  std::vector<Value> values(const XmlElement& array) const;

  const Source& source_;
  ByteOrder order_;
  std::size_t header_bytes_;  // of each number in the header of an array's bytes
  std::optional<BlockPacking> packing_;
  std::string appended_;
  bool appended_base64_;
};

}  // namespace foramen::io_detail
