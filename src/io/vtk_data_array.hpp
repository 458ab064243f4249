#pragma once
/// \file
/// Private to io: the numbers of a DataArray of VTK's XML files, however they are written.

#include <cstdint>
#include <string>
#include <vector>

#include "io/xml_elements.hpp"

namespace foramen::io_detail {

/// Reads arrays of one file: text, base64 within the element, or appended at the end of the file, raw or
/// base64; zlib's blocks are unpacked. Throws IoError: an array that is missing, damaged, of another type or
/// compressed otherwise. No memory is taken for what a header promises, only for what the file can hold.
class VtkDataArrays {
 public:
  /// \param file  the root element  \param appended  what follows the mark '_' of AppendedData; empty if
  /// there is none  \param appended_base64  whether it is base64
  VtkDataArrays(const Source& source, const XmlElement& file, std::string_view appended,
                bool appended_base64);

  /// The array of that name among an element's children (of points: the only one).
  const XmlElement& find(const XmlElement& parent, const std::string& name) const;
  std::vector<double> numbers(const XmlElement& array) const;
  /// Refuses an array of floating point numbers.
  std::vector<std::int64_t> integers(const XmlElement& array) const;
  /// Characters by their codes, up to the first NUL.
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
  bool zlib_;
  std::string appended_;
  bool appended_base64_;
};

}  // namespace foramen::io_detail
