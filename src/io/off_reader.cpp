#include <algorithm>
#include <array>
#include <vector>

#include "io/mesh_formats.hpp"

namespace foramen::io_detail {
namespace {

class OffParser {
 public:
  explicit OffParser(const Source& source) : source_(source), lines_(source.bytes), soup_(source) {}

  MeshFile parse() {
    parse_keyword();
    const auto [vertices, faces] = parse_counts();
    constexpr std::uint64_t shortest_vertex = 6, shortest_face = 2;  // "0 0 0\n", "0\n"
    soup_.expect(vertices, faces, lines_.remaining() + 1, shortest_vertex, shortest_face);
    for (std::uint64_t v = 0; v < vertices; ++v) parse_vertex(v, vertices);
    for (std::uint64_t f = 0; f < faces; ++f) parse_face(f, faces, vertices);
    if (next_line()) soup_.pass_over_trailing(line_.size() + lines_.remaining());
    return soup_.finish(space_.value());
  }

 private:
  struct Counts {
    std::uint64_t vertices, faces;
  };

  [[noreturn]] void refuse(const std::string& found, const char* remedy = remedy_export_again) const {
    source_.refuse(lines_.place() + ": " + found, remedy);
  }

  // Goes to the next line that is not blank or a comment; line_ is the part before the '#'.
  bool next_line() {
    while (lines_.next_filled()) {
      const std::string_view whole = lines_.line();
      const auto comment = whole.find('#');
      if (comment != std::string_view::npos) space_.see(source_, whole.substr(comment));
      line_ = whole.substr(0, comment);
      words_ = TokenCursor(line_);
      if (!words_.rest().empty()) return true;
    }
    return false;
  }

  void need_line(const std::string& what) {
    if (!next_line()) source_.refuse("the file ends before " + what, remedy_export_again);
  }

  void parse_keyword() {
    need_line("the word 'OFF'");
    const std::string_view keyword = words_.next();
    // Texture coordinates, colours and normals follow the coordinates of a vertex.
    constexpr std::array<std::string_view, 8> read{"OFF",   "COFF",   "NOFF",   "CNOFF",
                                                   "STOFF", "STCOFF", "STNOFF", "STCNOFF"};
    if (std::find(read.begin(), read.end(), keyword) == read.end()) {
      if (keyword.ends_with("OFF"))
        refuse("the variant " + in_quotes(keyword) + " is not read",
               "save it as plain OFF in three dimensions");
      refuse("expected 'OFF', found " + in_quotes(keyword),
             "it is no OFF file: check its format and extension");
    }
    if (lower_case(TokenCursor(words_.rest()).next()) == "binary")
      refuse("binary OFF is not read", "save it as text, or as PLY");
    if (words_.rest().empty()) need_line("the numbers of vertices and faces");
  }

  Counts parse_counts() {
    const auto vertices = to_integer(words_.next()), faces = to_integer(words_.next());
    const std::string_view edges = words_.next();  // often wrong in practice, and not needed
    if (!vertices || !faces || *vertices < 0 || *faces < 0 || (!edges.empty() && !to_integer(edges)) ||
        !words_.rest().empty())
      refuse("expected the numbers of vertices, faces and edges, found " + in_quotes(line_));
    return {static_cast<std::uint64_t>(*vertices), static_cast<std::uint64_t>(*faces)};
  }

  void parse_vertex(std::uint64_t index, std::uint64_t count) {
    need_line("vertex " + std::to_string(index) + " of " + std::to_string(count));
    Vec3 point;
    for (int k = 0; k < 3; ++k) {
      const auto value = to_number(words_.next());
      if (!value)
        refuse("expected the three coordinates of vertex " + std::to_string(index) + ", found " +
               in_quotes(line_));
      point[k] = *value;
    }
    for (std::string_view word = words_.next(); !word.empty(); word = words_.next())
      if (!to_number(word))
        refuse("unexpected " + in_quotes(word) + " after vertex " + std::to_string(index));
    soup_.add_point(point, [&] { return lines_.place(); });
  }

  // A face is "3 i j k", or another number of corners, optionally followed by a colour of up to four numbers.
  void parse_face(std::uint64_t index, std::uint64_t count, std::uint64_t vertices) {
    need_line("face " + std::to_string(index) + " of " + std::to_string(count));
    const auto corner_count = to_integer(words_.next());
    if (!corner_count || *corner_count < 0)
      refuse("expected a face such as '3 0 1 2', found " + in_quotes(line_));
    corners_.clear();
    for (std::int64_t k = 0; k < *corner_count; ++k) {
      const auto value = to_integer(words_.next());
      if (!value) refuse("expected a face such as '3 0 1 2', found " + in_quotes(line_));
      corners_.push_back(*value);
    }
    constexpr int longest_colour = 4;
    int extra = 0;
    for (std::string_view word = words_.next(); !word.empty(); word = words_.next(), ++extra)
      if (extra == longest_colour || !to_number(word))
        refuse("unexpected " + in_quotes(word) + " after face " + std::to_string(index));
    soup_.add_face(corners_, vertices, [&] { return lines_.place(); });
  }

  const Source& source_;
  LineCursor lines_;
  SoupBuilder soup_;
  SpaceTag space_;
  std::vector<std::int64_t> corners_;  // of the present face
  std::string_view line_;
  TokenCursor words_{std::string_view()};
};

}  // namespace

MeshFile parse_off(const Source& source) { return OffParser(source).parse(); }

}  // namespace foramen::io_detail
