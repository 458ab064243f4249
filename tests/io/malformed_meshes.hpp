#pragma once
/// \file
/// Mesh files with one defect each, and the text that the error must contain.

#include <cmath>
#include <cstdint>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/mesh_bytes.hpp"

namespace foramen::testing::malformed {

struct Malformed {
  std::string name, extension, bytes, message;
};

inline void PrintTo(const Malformed& m, std::ostream* out) { *out << m.name; }

inline const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
inline const std::string list = "property list uchar int vertex_indices\n";

inline std::string ply(const std::string& vertices, const std::string& faces, const std::string& body,
                       const std::string& encoding = "ascii") {
  return "ply\nformat " + encoding + " 1.0\nelement vertex " + vertices + "\n" + xyz + "element face " +
         faces + "\n" + list + "end_header\n" + body;
}

inline const std::string three = "0 0 0\n1 0 0\n0 1 0\n";

inline std::string binary_triangle(const std::string& count, const std::string& last_corner,
                                   float first_x = 0) {
  std::string body = raw(first_x);
  for (float x : {0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F}) body += raw(x);
  return body + count + raw(std::int32_t{0}) + raw(std::int32_t{1}) + last_corner;
}

inline std::string with(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  if (at == std::string::npos) throw std::logic_error("a case for malformed files replaces nothing: " + from);
  return text.replace(at, from.size(), to);
}

inline std::string many_corners(int count) {
  std::string face = std::to_string(count);
  for (int k = 0; k < count; ++k) face.append(" ").append(std::to_string(k % 3));
  return face + "\n";
}

inline std::vector<Malformed> ply_files() {
  const std::string le = "binary_little_endian", ok = ply("3", "1", three + "3 0 1 2\n"), c3 = "\3";
  const std::string binary = ply("3", "1", binary_triangle(c3, raw(std::int32_t{2})), le);
  return {
      {"empty", "ply", "", "is empty"},
      {"not_ply", "ply", "solid x\n", "does not begin with the line 'ply'"},
      {"no_format", "ply", "ply\nelement vertex 3\n", "line 2: expected 'format'"},
      {"unknown_format", "ply", with(ok, "ascii", "utf8"), "line 2: unknown format 'utf8'"},
      {"unknown_version", "ply", with(ok, "1.0", "2.0"), "unknown PLY version '2.0'"},
      {"unknown_line", "ply", with(ok, "element face", "elements face"),
       "line 7: unknown header line 'elements face 1'"},
      {"unknown_type", "ply", with(ok, "property float y", "property real y"), "line 5: unknown type 'real'"},
      {"property_first", "ply", "ply\nformat ascii 1.0\nproperty float x\n",
       "line 3: a property before any element"},
      {"property_twice", "ply", with(ok, "float y", "float x"), "line 5: property 'x' is declared twice"},
      {"element_twice", "ply", with(ok, "element face 1", "element vertex 1"),
       "element 'vertex' is declared twice"},
      {"negative_count", "ply", with(ok, "vertex 3", "vertex -3"), "line 3: expected 'element NAME COUNT'"},
      {"count_no_number", "ply", with(ok, "vertex 3", "vertex many"),
       "line 3: expected 'element NAME COUNT'"},
      {"float_list_length", "ply", with(ok, "list uchar", "list float"), "a list whose length is no integer"},
      {"header_cut_off", "ply", ok.substr(0, ok.find("end_header")), "no 'end_header' line"},
      {"no_coordinate", "ply", with(ok, "property float z\n", ""), "its vertices have no number 'z'"},
      {"list_coordinate", "ply", with(ok, "property float z", "property list uchar float z"),
       "no number 'z'"},
      {"no_faces", "ply", "ply\nformat ascii 1.0\nelement vertex 1\n" + xyz + "end_header\n0 0 0\n",
       "no element 'face'"},
      {"no_vertices", "ply", "ply\nformat ascii 1.0\nelement face 1\n" + list + "end_header\n3 0 1 2\n",
       "no element 'vertex'"},
      {"float_corners", "ply", with(ok, "uchar int", "uchar float"), "no single list 'vertex_indices'"},
      {"two_corner_lists", "ply", with(ok, list, list + "property list uchar int vertex_index\n"),
       "no single list"},
      {"comments_without_end", "ply", "ply\ncomment x\nobj_info y\n", "the header ends before 'format'"},
      {"strip_corner", "ply", with(ply("3", "1", three + "4 0 1 2 3\n"), "element face", "element tristrips"),
       "line 13: uses vertex 3"},
      {"zero_faces", "ply", ply("3", "0", three), "holds no triangles (3 vertices)"},
      {"unknown_space", "ply", with(ok, "element vertex", "comment SPACE=LAS\nelement vertex"),
       "SPACE tag says 'LAS'"},
      {"two_spaces", "ply", with(ok, "element vertex", "comment SPACE=LPS SPACE=RAS\nelement vertex"),
       "both SPACE=LPS and"},
      {"bigon", "ply", ply("3", "1", three + "2 0 1 \n"), "holds no triangles"},
      {"corner_too_large", "ply", ply("3", "1", three + "3 0 1 3\n"),
       "line 13: uses vertex 3, but there are 3 vertices"},
      {"corner_negative", "ply", ply("3", "1", three + "3 0 -1 2\n"), "line 13: uses vertex -1"},
      {"nan", "ply", ply("3", "1", "0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n"),
       "line 11: a coordinate is not a finite"},
      {"inf", "ply", ply("3", "1", "0 0 0\n1 0 0\n0 -inf 0\n3 0 1 2\n"),
       "line 12: a coordinate is not a finite"},
      {"overflow", "ply", ply("3", "1", "0 0 1e999\n1 0 0\n0 1 0\n3 0 1 2\n"), "line 10: expected a number"},
      {"no_number", "ply", ply("3", "1", "0 0 0\n1 0 zero\n0 1 0\n3 0 1 2\n"),
       "line 11: expected a number in '1 0 zero'"},
      {"hexadecimal", "ply", ply("3", "1", "0 0 0\n1 0x1 0\n0 1 0\n3 0 1 2\n"), "line 11: expected a number"},
      {"row_too_short", "ply", ply("3", "1", "0 0 0\n1 0\n0 1 0\n3 0 1 2\n"), "line 11: expected a number"},
      {"row_too_long", "ply", ply("3", "1", "0 0 0\n1 0 0 7\n0 1 0\n3 0 1 2\n"), "line 11: more values"},
      {"text_cut_off", "ply", ply("3", "2", three + "3 0 1 2\n"), "the file ends before face 1 of 2"},
      {"lying_text_count", "ply", ply("4000000000000", "1", three), "announces 4000000000000 x 'vertex'"},
      {"lying_count", "ply", ply("2000000000", "1", "xx", le),
       "announces 2000000000 x 'vertex' of at least 12 bytes"},
      {"lying_huge_count", "ply", ply("9223372036854775807", "1", "xx", le), "but only 2 bytes are left"},
      {"lying_face_count", "ply", with(binary, "face 1", "face 5000"), "announces 5000 x 'face'"},
      {"empty_element", "ply", with(ok, "element vertex", "element nothing 9999999999\nelement vertex"),
       "has no properties"},
      {"binary_cut_off", "ply", binary.substr(0, binary.size() - 1),
       "the file ends at byte 217, within face 0"},
      {"binary_corner", "ply", ply("3", "1", binary_triangle(c3, raw(std::int32_t{-7})), le),
       "face 0: uses vertex -7"},
      {"binary_nan", "ply", ply("3", "1", binary_triangle(c3, raw(std::int32_t{2}), std::nanf("")), le),
       "vertex 0: a coordinate is not a finite number"},
      {"negative_list", "ply",
       with(ply("3", "1", binary_triangle("\xff", raw(std::int32_t{2})), le), "list uchar", "list char"),
       "face 0: a list of length -1"},
      {"endless_skipped_list", "ply",
       with(ply("3", "1", three + std::string(99, '7'), le), "property float z",
            "property float z\nproperty list uint double w"),
       "the file ends at byte"},
  };
}

inline std::vector<Malformed> stl_files() {
  const std::string binary = binary_stl(tetrahedron()), text = ascii_stl(tetrahedron());
  std::string nan = binary;
  nan.replace(84 + 50 + 12, 4, raw(std::nanf("")));
  return {
      {"too_short", "stl", "short", "neither a binary STL (at least 84 bytes) nor a text one"},
      {"cut_off", "stl", binary.substr(0, binary.size() - 1),
       "announces 4 facets, which need 284 bytes, but has 283"},
      {"lying_count", "stl", with(binary, raw(std::uint32_t{4}), raw(std::uint32_t{0xffffffff})),
       "announces 4294967295 facets"},
      {"solid_header_cut_off", "stl", binary_stl(tetrahedron(), "solid").substr(0, 200),
       "announces 4 facets"},
      {"no_facets", "stl", binary_stl({}), "holds no triangles"},
      {"nan", "stl", nan, "facet 1: a coordinate is not a finite number"},
      {"text_empty", "stl", "solid x\nendsolid x\n", "holds no triangles"},
      {"text_cut_off", "stl", text.substr(0, text.find("endsolid")),
       "the file ends where 'endsolid' should follow"},
      {"text_cut_in_facet", "stl", text.substr(0, text.find("endloop")),
       "the file ends where 'endloop' should follow"},
      {"text_two_corners", "stl", with(text, "   vertex 0.000000 0.000000 0.000000\n", ""),
       "expected 'vertex', found '  endloop'"},
      {"text_quad", "stl", with(text, "  endloop", "   vertex 1 1 1\n  endloop"),
       "line 7: a facet with more than three corners"},
      {"text_nan", "stl", with(text, "vertex 0.000000 0.000000", "vertex nan 0.000000"),
       "line 4: a coordinate is not a finite"},
      {"text_no_number", "stl", with(text, "vertex 0.000000", "vertex zero"),
       "line 4: expected three numbers"},
      {"text_keyword", "stl", with(text, "outer loop", "outer lop"), "line 3: expected 'loop'"},
      {"text_after_facet", "stl", with(text, "endfacet", "endfacet x"), "unexpected 'x'"},
  };
}

inline std::vector<Malformed> obj_files() {
  const std::string v = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  return {
      {"garbage", "obj", std::string("\x01\x02 what", 7), "line 1: unknown line '?? what'"},
      {"no_faces", "obj", v, "holds no triangles (3 vertices)"},
      {"zero", "obj", v + "f 0 1 2\n", "line 4: expected a corner such as 7"},
      {"too_large", "obj", v + "f 1 2 4\n", "line 4: uses vertex 4, but there are 3 vertices"},
      {"too_negative", "obj", v + "f 1 2 -4\n", "line 4: uses vertex -4, but there are 3 vertices"},
      {"int_overflow", "obj", v + "f 1 2 4294967297\n", "line 4: uses vertex 4294967297"},
      {"no_integer", "obj", v + "f 1 2 3.5\n", "found '3.5'"},
      {"open_slash", "obj", v + "f 1 2 3/\n", "found '3/'"},
      {"four_parts", "obj", v + "f 1 2 3/1/1/1\n", "found '3/1/1/1'"},
      {"nan", "obj", v + "v nan 0 0\nf 1 2 3\n", "line 4: a coordinate is not a finite number"},
      {"two_numbers", "obj", v + "v 1 2\nf 1 2 3\n", "line 4: a vertex of 2 numbers"},
      {"weight", "obj", v + "v 1 2 3 0.5\nf 1 2 3\n", "line 4: a vertex with a weight other than 1"},
      {"free_form", "obj", v + "curv 0 1 1 2 3\nf 1 2 3\n", "line 4: unknown line 'curv 0 1 1 2 3'"},
  };
}

inline std::vector<Malformed> off_files() {
  return {
      {"no_keyword", "off", "3 1 0\n" + three + "3 0 1 2\n", "line 1: expected 'OFF', found '3'"},
      {"four_dimensions", "off", "4OFF\n3 1 0\n", "the variant '4OFF' is not read"},
      {"binary", "off", "OFF BINARY\nxxxx", "binary OFF is not read"},
      {"only_keyword", "off", "OFF\n# nothing\n", "the file ends before the numbers of vertices and faces"},
      {"one_count", "off", "OFF\n3\n", "expected the numbers of vertices, faces and edges, found '3'"},
      {"negative_count", "off", "OFF\n-3 1 0\n", "expected the numbers of vertices, faces and edges"},
      {"lying_count", "off", "OFF\n300000000 1 0\n" + three,
       "announces 300000000 vertices and 1 faces, which need at least"},
      {"huge_count", "off", "OFF\n3 9223372036854775807 0\n" + three, "more than foramen can hold"},
      {"cut_off", "off", "OFF\n3 1 0\n" + three + "#             \n", "the file ends before face 0 of 1"},
      {"corner", "off", "OFF\n3 1 0\n" + three + "3 0 1 3\n",
       "line 6: uses vertex 3, but there are 3 vertices"},
      {"inf", "off", "OFF\n3 1 0\n0 0 0\n1 inf 0\n0 1 0\n3 0 1 2\n", "line 4: a coordinate is not a finite"},
      {"no_colour", "off", "COFF\n3 1 0\n0 0 0 red\n1 0 0\n0 1 0\n3 0 1 2\n",
       "unexpected 'red' after vertex 0"},
      {"too_many_corners", "off", "OFF\n3 1 0\n" + three + many_corners(201), "a face with 201 corners"},
      {"no_number", "off", "OFF\n3 1 0\n0 0 0\n1 0 x\n0 1 0\n3 0 1 2\n",
       "line 4: expected the three coordinates of vertex 1"},
      {"no_face", "off", "OFF\n3 1 0\n" + three + "3 0 1   \n", "line 6: expected a face such as"},
      {"long_colour", "off", "OFF\n3 1 0\n" + three + "3 0 1 2 1 1 1 1 1\n", "unexpected '1' after face 0"},
  };
}

inline std::vector<Malformed> all_files() {
  std::vector<Malformed> all;
  for (const auto& files : {ply_files(), stl_files(), obj_files(), off_files()})
    all.insert(all.end(), files.begin(), files.end());
  return all;
}

}  // namespace foramen::testing::malformed
