#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "io/mesh_formats.hpp"

namespace foramen::io_detail {
namespace {

constexpr std::size_t header_bytes = 80, preamble_bytes = header_bytes + 4, facet_bytes = 50;

std::uint64_t announced_facets(const Source& source) {
  return ByteCursor(source.bytes, header_bytes, ByteOrder::little).read<std::uint32_t>();
}

bool is_text(std::string_view bytes) {
  return std::none_of(bytes.begin(), bytes.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 7 || byte == 127 || (byte > 13 && byte < 27);
  });
}

// The number of facets of a binary file. Some programs write 0 and leave it so; then all whole facets that
// follow are taken.
std::uint64_t binary_facets(const Source& source) {
  const std::uint64_t announced = announced_facets(source);
  return announced > 0 ? announced : (source.bytes.size() - preamble_bytes) / facet_bytes;
}

// A binary file may begin with "solid", too. If the number of facets in the header agrees with the file size,
// the file is binary: in a text file the same four bytes would stand for far more facets. Otherwise the file
// is a text if it begins with "solid" and its beginning has only text characters.
bool is_binary(const Source& source) {
  if (source.bytes.size() >= preamble_bytes &&
      source.bytes.size() == preamble_bytes + facet_bytes * announced_facets(source))
    return true;
  constexpr std::size_t looked_at = 1024;
  const std::string_view start = source.bytes.substr(0, looked_at).substr(byte_order_mark(source.bytes));
  return lower_case(TokenCursor(start).next()) != "solid" || !is_text(start);
}

// Makes one point of all corners with exactly equal coordinates (0 equals -0). Points are in the order in
// which they first appear.
TriangleSoup welded(const std::vector<Vec3>& corners) {
  const auto key = [&](int i) {
    const Vec3& p = corners[i];
    return std::tuple(p.x(), p.y(), p.z());
  };
  std::vector<int> order(corners.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return key(a) != key(b) ? key(a) < key(b) : a < b; });
  std::vector<int> first(corners.size());  // per corner: the first corner at its place
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && key(order[i]) == key(order[i - 1]);
    first[order[i]] = same ? first[order[i - 1]] : order[i];
  }
  TriangleSoup soup;
  std::vector<int> point(corners.size());
  for (std::size_t c = 0; c < corners.size(); ++c) {
    const std::size_t original = first[c];
    if (original == c) {
      point[c] = static_cast<int>(soup.points.size());
      soup.points.push_back(corners[c]);
    } else {
      point[c] = point[original];
    }
  }
  soup.triangles.reserve(corners.size() / 3);
  for (std::size_t c = 0; c + 2 < corners.size(); c += 3)
    soup.triangles.push_back({point[c], point[c + 1], point[c + 2]});
  return soup;
}

struct Corners {
  std::vector<Vec3> corners;
  std::uint64_t trailing = 0;  // bytes after the last facet
};

Corners read_binary(const Source& source) {
  if (source.bytes.size() < preamble_bytes)
    source.refuse(
        "has " + std::to_string(source.bytes.size()) +
            " bytes and does not begin with 'solid': neither a binary STL (at least 84 bytes) nor a text one",
        "check its format and extension, or export the surface again");
  const std::uint64_t facets = binary_facets(source), expected = preamble_bytes + facet_bytes * facets;
  if (source.bytes.size() < expected)
    source.refuse("announces " + std::to_string(facets) + " facets, which need " + std::to_string(expected) +
                      " bytes, but has " + std::to_string(source.bytes.size()),
                  "it is no STL file, is damaged or was cut off: export or copy it again");
  SoupBuilder limits(source);
  limits.expect(0, facets, source.bytes.size(), 0, facet_bytes);
  ByteCursor bytes(source.bytes, preamble_bytes, ByteOrder::little);
  std::vector<Vec3> corners;
  corners.reserve(3 * facets);
  const auto read_vector = [&] {
    const float x = bytes.read<float>(), y = bytes.read<float>(), z = bytes.read<float>();
    return Vec3(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z));
  };
  for (std::uint64_t f = 0; f < facets; ++f) {
    read_vector();  // the normal is ignored, since the corners determine it
    for (int k = 0; k < 3; ++k) {
      corners.push_back(read_vector());
      if (!corners.back().allFinite())
        source.refuse("facet " + std::to_string(f) + ": a coordinate is not a finite number",
                      "remove that facet in a mesh editor or export the surface again");
    }
    bytes.read<std::uint16_t>();  // attribute bytes, in which some programs store a colour
  }
  return {std::move(corners), source.bytes.size() - expected};
}

class TextStl {
 public:
  TextStl(const Source& source, SpaceTag& space) : source_(source), lines_(source.bytes), space_(space) {}

  Corners read() {
    while (lines_.next_filled()) {
      TokenCursor words(lines_.line());
      if (!corners_.empty() && lower_case(words.next()) != "solid") {
        trailing_ = lines_.line().size() + lines_.remaining();
        break;
      }
      read_solid();
    }
    return {std::move(corners_), trailing_};
  }

 private:
  [[noreturn]] void refuse(const std::string& found) const {
    source_.refuse(lines_.place() + ": " + found, remedy_export_again);
  }
  // The words of the next line; refuses the file if it ends here.
  TokenCursor next_words(const char* expected) {
    if (!lines_.next_filled()) refuse(std::string("the file ends where '") + expected + "' should follow");
    return TokenCursor(lines_.line());
  }
  void expect(TokenCursor& words, std::string_view word) {
    if (lower_case(words.next()) != word)
      refuse("expected '" + std::string(word) + "', found " + in_quotes(lines_.line()));
  }
  void expect_end(TokenCursor& words) {
    if (!words.rest().empty()) refuse("unexpected " + in_quotes(words.rest()));
  }
  void expect_line(std::string_view first, std::string_view second = {}) {
    TokenCursor words = next_words(first.data());
    expect(words, first);
    if (!second.empty()) expect(words, second);
    expect_end(words);
  }

  void read_solid() {
    TokenCursor title(lines_.line());
    expect(title, "solid");
    space_.see(source_, title.rest());
    for (;;) {
      TokenCursor words = next_words("endsolid");
      TokenCursor look = words;
      if (lower_case(look.next()) == "endsolid") return;
      read_facet(words);
    }
  }

  void read_facet(TokenCursor words) {
    expect(words, "facet");
    expect(words, "normal");
    for (int k = 0; k < 3; ++k)
      if (words.next().empty()) refuse("a normal with fewer than three numbers");
    expect_end(words);
    expect_line("outer", "loop");
    for (int k = 0; k < 3; ++k) read_corner();
    TokenCursor end = next_words("endloop");
    const std::string keyword = lower_case(end.next());
    if (keyword == "vertex")
      source_.refuse(lines_.place() + ": a facet with more than three corners", remedy_triangulate);
    if (keyword != "endloop") refuse("expected 'endloop', found " + in_quotes(lines_.line()));
    expect_end(end);
    expect_line("endfacet");
  }

  void read_corner() {
    TokenCursor words = next_words("vertex");
    expect(words, "vertex");
    Vec3 corner;
    for (int k = 0; k < 3; ++k) {
      const auto value = to_number(words.next());
      if (!value) refuse("expected three numbers, found " + in_quotes(lines_.line()));
      corner[k] = *value;
    }
    expect_end(words);
    if (!corner.allFinite()) refuse("a coordinate is not a finite number");
    corners_.push_back(corner);
  }

  const Source& source_;
  LineCursor lines_;
  SpaceTag& space_;
  std::vector<Vec3> corners_;
  std::uint64_t trailing_ = 0;
};

}  // namespace

MeshFile parse_stl(const Source& source) {
  SpaceTag space;
  Corners read;
  if (is_binary(source)) {
    read = read_binary(source);
    space.see(source, source.bytes.substr(0, header_bytes));
  } else {
    read = TextStl(source, space).read();
  }
  if (read.corners.empty()) source.refuse("holds no triangles", "export the surface, not an empty scene");
  MeshFile file{welded(read.corners), space.value(), {}};
  if (read.trailing > 0)
    file.notes.emplace_back(std::to_string(read.trailing) + " bytes after the surface passed over");
  return file;
}

}  // namespace foramen::io_detail
