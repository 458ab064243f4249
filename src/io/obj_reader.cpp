#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <vector>

#include "io/mesh_formats.hpp"

namespace foramen::io_detail {
namespace {

// Keywords that do not change the surface: textures, normals, names, materials and how they are displayed.
constexpr std::array<std::string_view, 17> ignored_keywords{
    "vt",     "vn",     "vp",    "g",   "o",        "s",        "mg",         "usemtl",   "mtllib",
    "usemap", "maplib", "bevel", "lod", "c_interp", "d_interp", "shadow_obj", "trace_obj"};

class ObjParser {
 public:
  explicit ObjParser(const Source& source) : source_(source), lines_(source.bytes), soup_(source) {}

  MeshFile parse() {
    while (next_line()) parse_line();
    for (const Face& face : faces_) {
      const auto place = [&] { return "line " + std::to_string(face.line); };
      const std::span corners(corners_.data() + face.first_corner, face.corners);
      for (std::int64_t corner : corners)  // the file counts vertices from 1
        if (static_cast<std::size_t>(corner) >= soup_.points())
          soup_.refuse_corner(corner + 1, soup_.points(), place());
      soup_.add_face(corners, soup_.points(), place);
    }
    return soup_.finish(space_.value());
  }

 private:
  struct Face {
    std::size_t first_corner, corners;  // in corners_
    std::size_t line;
  };

  // Goes to the next line that is not blank; joins it with those on which a backslash at its end continues
  // it.
  bool next_line() {
    if (!lines_.next_filled()) return false;
    line_ = lines_.line();
    number_ = lines_.number();
    if (!TokenCursor(line_).rest().ends_with('\\')) return true;
    joined_.clear();
    for (std::string_view part = TokenCursor(line_).rest();; part = TokenCursor(lines_.line()).rest()) {
      const bool continued = part.ends_with('\\');
      joined_.append(part.substr(0, part.size() - (continued ? 1 : 0))).append(" ");
      if (!continued || !lines_.next()) break;
    }
    line_ = joined_;
    return true;
  }
  std::string place() const { return "line " + std::to_string(number_); }

  [[noreturn]] void refuse(const std::string& found, const char* remedy = remedy_export_again) const {
    source_.refuse(place() + ": " + found, remedy);
  }

  void parse_line() {
    TokenCursor words(line_);
    const std::string_view keyword = words.next();
    if (keyword.starts_with('#')) {
      space_.see(source_, line_);
      return;
    }
    if (keyword.empty()) return;  // a line of backslashes alone
    if (keyword == "v")
      parse_vertex(words);
    else if (keyword == "f" || keyword == "fo")
      parse_face(words);
    else if (keyword == "p" || keyword == "l")
      soup_.pass_over_loose(1);
    else if (std::find(ignored_keywords.begin(), ignored_keywords.end(), keyword) == ignored_keywords.end())
      refuse("unknown line " + in_quotes(line_), remedy_other_format);
  }

  // A vertex is x y z, followed by nothing, by a weight of 1 or by a colour.
  void parse_vertex(TokenCursor words) {
    std::vector<double> values;
    for (std::string_view word = words.next(); !word.empty() && !word.starts_with('#'); word = words.next()) {
      const auto value = to_number(word);
      if (!value) refuse("expected a number, found " + in_quotes(word));
      values.push_back(*value);
    }
    if (values.size() < 3 || values.size() > 7 || values.size() == 5)
      refuse("a vertex of " + std::to_string(values.size()) + " numbers instead of 3");
    if (values.size() == 4 && values[3] != 1)
      refuse("a vertex with a weight other than 1", remedy_other_format);
    soup_.add_point({values[0], values[1], values[2]}, [&] { return place(); });
  }

  // A corner is v, v/vt, v//vn or v/vt/vn with integers. A negative v counts back from the last vertex so
  // far.
  std::int64_t parse_corner(std::string_view word) const {
    std::int64_t vertex = 0;
    std::size_t part = 0;
    for (std::size_t begin = 0; begin <= word.size(); ++part) {
      const std::size_t end = std::min(word.find('/', begin), word.size());
      const auto value = to_integer(word.substr(begin, end - begin));
      const bool left_out = begin == end && part == 1 && end != word.size();
      if (part > 2 || (!value && !left_out) || (value && *value == 0))
        refuse("expected a corner such as 7, 7/1, 7//1 or 7/1/1, found " + in_quotes(word));
      if (part == 0) vertex = *value;
      begin = end + 1;
    }
    const auto known = static_cast<std::int64_t>(soup_.points());
    if (vertex > 0) return vertex - 1;
    if (-vertex > known) soup_.refuse_corner(vertex, soup_.points(), place());
    return known + vertex;
  }

  void parse_face(TokenCursor words) {
    Face face{corners_.size(), 0, number_};
    for (std::string_view word = words.next(); !word.empty() && !word.starts_with('#'); word = words.next()) {
      corners_.push_back(parse_corner(word));
    }
    face.corners = corners_.size() - face.first_corner;
    faces_.push_back(face);
  }

  const Source& source_;
  LineCursor lines_;
  SoupBuilder soup_;
  SpaceTag space_;
  std::vector<Face> faces_;  // their vertices may still follow in the file
  std::vector<std::int64_t> corners_;
  std::string_view line_;
  std::size_t number_ = 0;  // of the first line of line_
  std::string joined_;
};

}  // namespace

MeshFile parse_obj(const Source& source) { return ObjParser(source).parse(); }

}  // namespace foramen::io_detail
