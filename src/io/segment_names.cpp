#include "io/segment_names.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "foramen/core/error.hpp"
#include "io/xml_elements.hpp"

namespace foramen::io_detail {
namespace {

constexpr std::int64_t largest_label = std::numeric_limits<std::uint16_t>::max();

std::string trimmed(std::string_view text) {
  constexpr std::string_view blank = " \t\r\n";
  const auto first = text.find_first_not_of(blank);
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(blank) - first + 1));
}

// The element of that name, the root itself or the first one below it.
const XmlElement* find_element(const XmlElement& root, std::string_view name) {
  if (root.name == name) return &root;
  for (const XmlElement& child : root.children)
    if (const XmlElement* found = find_element(child, name)) return found;
  return nullptr;
}

std::map<int, std::string> names_in_table(const XmlElement& table) {
  std::map<int, std::string> names;
  for (const XmlElement& label : table.children) {
    const auto key = to_integer(label.attribute("Key"));
    const std::string name = trimmed(label.text);
    if (label.name == "Label" && key && *key >= 1 && *key <= largest_label && !name.empty())
      names.emplace(static_cast<int>(*key), name);
  }
  return names;
}

}  // namespace

void SegmentNames::add(std::string_view key, std::string_view value) {
  constexpr std::string_view prefix = "Segment";
  const auto underscore = key.find('_');
  if (!key.starts_with(prefix) || underscore == std::string_view::npos) return;
  const auto number = to_integer(key.substr(prefix.size(), underscore - prefix.size()));
  if (!number) return;
  const std::string_view field = key.substr(underscore + 1);
  if (field == "Name")
    segments_[*number].name = trimmed(value);
  else if (field == "LabelValue")
    segments_[*number].label = to_integer(trimmed(value)).value_or(0);
  else if (field == "Layer")
    segments_[*number].layer = to_integer(trimmed(value)).value_or(0);
}

std::vector<std::map<int, std::string>> SegmentNames::by_layer(std::int64_t layers) const {
  std::vector<std::map<int, std::string>> names(layers);
  for (const auto& [number, segment] : segments_) {
    const bool named = !segment.name.empty() && segment.label >= 1 && segment.label <= largest_label;
    if (named && segment.layer >= 0 && segment.layer < layers)
      names[segment.layer].emplace(static_cast<int>(segment.label), segment.name);
  }
  return names;
}

std::map<int, std::string> names_in_extensions(const Source& source, std::string_view extensions,
                                               ByteOrder order) {
  constexpr std::size_t head = 8;  // size with these 8 bytes, and code
  while (extensions.size() > head) {
    const auto size = ByteCursor(extensions, 0, order).read<std::int32_t>();
    if (size <= static_cast<std::int32_t>(head) || static_cast<std::size_t>(size) > extensions.size()) break;
    std::string_view content = extensions.substr(head, size - head);
    content = content.substr(0, content.find_last_not_of('\0') + 1);
    extensions.remove_prefix(size);
    if (content.find("<LabelTable") == std::string_view::npos) continue;
    try {
      const XmlElement root = parse_xml(source, content);
      if (const XmlElement* table = find_element(root, "LabelTable")) return names_in_table(*table);
    } catch (const IoError&) {
      continue;
    }
  }
  return {};
}

}  // namespace foramen::io_detail
