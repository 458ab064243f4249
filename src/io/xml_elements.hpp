#pragma once
/// \file
/// Private to io: an XML document as a tree.

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "io/file_bytes.hpp"

namespace foramen::io_detail {

struct XmlElement {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::string text;  ///< all text directly in the element, without that of its children
  std::vector<XmlElement> children;

  /// The attribute, or `missing` if there is none.
  std::string attribute(const std::string& key, const std::string& missing = {}) const;
  /// The first child of that name; null if there is none.
  const XmlElement* child(std::string_view child_name) const;
};

/// Parses a document and returns its root element. Throws IoError if the text is not well-formed XML, is
/// nested deeper than 20 elements or has more than a million, or declares a document type: no file that
/// foramen reads needs one, and its entities can expand to unlimited size.
XmlElement parse_xml(const Source& source, std::string_view text);

}  // namespace foramen::io_detail
