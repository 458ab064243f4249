#include "io/xml_elements.hpp"

#include <expat.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>

namespace foramen::io_detail {
namespace {

// An element of four bytes takes a hundred in memory, so their number is limited, too.
constexpr std::size_t deepest = 20, most_elements = 1000000;

// The callbacks of expat. No exception may pass through expat, so an error is remembered and the parser is
// stopped.
class TreeBuilder {
 public:
  explicit TreeBuilder(XML_Parser parser) : parser_(parser) {
    XML_SetUserData(parser, this);
    XML_SetElementHandler(
        parser,
        [](void* self, const char* name, const char** attributes) { of(self).start(name, attributes); },
        [](void* self, const char*) { of(self).end(); });
    XML_SetCharacterDataHandler(parser, [](void* self, const char* text, int length) {
      of(self).open_.back().text.append(text, length);
    });
    XML_SetStartDoctypeDeclHandler(parser, [](void* self, const char*, const char*, const char*, int) {
      of(self).stop("declares a document type");
    });
  }
  const std::string& problem() const { return problem_; }
  XmlElement take_root() { return std::move(open_.front().children.front()); }

 private:
  static TreeBuilder& of(void* self) { return *static_cast<TreeBuilder*>(self); }
  void start(const char* name, const char** attributes) {
    if (open_.size() > deepest) return stop("is nested deeper than " + std::to_string(deepest) + " elements");
    if (++elements_ > most_elements)
      return stop("has more than " + std::to_string(most_elements) + " elements");
    XmlElement element;
    element.name = name;
    for (; *attributes != nullptr; attributes += 2) element.attributes[attributes[0]] = attributes[1];
    open_.push_back(std::move(element));
  }
  void end() {
    XmlElement finished = std::move(open_.back());
    open_.pop_back();
    open_.back().children.push_back(std::move(finished));
  }
  void stop(std::string problem) {
    problem_ = std::move(problem);
    XML_StopParser(parser_, XML_FALSE);
  }

  XML_Parser parser_;
  std::vector<XmlElement> open_ = {XmlElement{}};  // open elements from the document to the innermost one
  std::size_t elements_ = 0;
  std::string problem_;
};

// Newer versions of expat deprecate XML_GetCurrentLineNumber for a function that counts in 64 bits; older
// versions have only the former. The template keeps the compiler from seeing the function that is missing or
// deprecated.
template <class Parser>
std::uint64_t line_number(Parser parser) {
  if constexpr (requires { XML_GetCurrentLineNumber64(parser); })
    return XML_GetCurrentLineNumber64(parser);
  else
    return XML_GetCurrentLineNumber(parser);
}

}  // namespace

std::string XmlElement::attribute(const std::string& key, const std::string& missing) const {
  const auto found = attributes.find(key);
  return found == attributes.end() ? missing : found->second;
}

const XmlElement* XmlElement::child(std::string_view child_name) const {
  const auto found = std::find_if(children.begin(), children.end(),
                                  [&](const XmlElement& element) { return element.name == child_name; });
  return found == children.end() ? nullptr : &*found;
}

XmlElement parse_xml(const Source& source, std::string_view text) {
  const std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser(XML_ParserCreate(nullptr),
                                                                            &XML_ParserFree);
  TreeBuilder tree(parser.get());
  constexpr std::size_t piece = std::size_t{1} << 24U;  // expat counts with int
  for (bool last = false; !last;) {
    const std::string_view now = text.substr(0, piece);
    text.remove_prefix(now.size());
    last = text.empty();
    if (XML_Parse(parser.get(), now.data(), static_cast<int>(now.size()), last ? 1 : 0) == XML_STATUS_OK)
      continue;
    if (!tree.problem().empty()) source.refuse(tree.problem(), remedy_other_format);
    source.refuse("line " + std::to_string(line_number(parser.get())) + ": is no well-formed XML (" +
                      XML_ErrorString(XML_GetErrorCode(parser.get())) + ")",
                  remedy_export_again);
  }
  return tree.take_root();
}

}  // namespace foramen::io_detail
