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
  std::string text;  ///< all of it that stands directly in the element
  std::vector<XmlElement> children;

  /// The attribute, or that default.
  std::string attribute(const std::string& key, const std::string& missing = {}) const;
  /// The first child of that name; null if there is none.
  const XmlElement* child(std::string_view child_name) const;
};

/// The root element. Throws IoError if the text is no well-formed XML, declares a document type (none of the
/// files read here has one, and entities can be made to grow without end), or is nested deeper than 20
/// elements.
XmlElement parse_xml(const Source& source, std::string_view text);

}  // namespace foramen::io_detail
