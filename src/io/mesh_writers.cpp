#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "foramen/core/error.hpp"
#include "io/atomic_file.hpp"
#include "io/mesh_formats.hpp"

namespace foramen {
namespace io_detail {

void check_writable(const std::filesystem::path& path, const TriangleSoup& soup) {
  const auto refuse = [&](const std::string& what) {
    throw InvalidInput("cannot write " + path.string() + ": " + what);
  };
  constexpr std::size_t most = std::numeric_limits<std::int32_t>::max() / 3;  // offsets are 32-bit
  if (soup.points.size() > most || soup.triangles.size() > most) refuse("too many vertices or triangles");
  constexpr auto largest = static_cast<double>(std::numeric_limits<float>::max());
  for (std::size_t v = 0; v < soup.points.size(); ++v)
    for (int k = 0; k < 3; ++k)
      if (!(std::abs(soup.points[v][k]) <= largest))
        refuse("vertex " + std::to_string(v) + " has a coordinate that float32 cannot hold");
  const int count = static_cast<int>(soup.points.size());
  for (std::size_t f = 0; f < soup.triangles.size(); ++f)
    for (int corner : soup.triangles[f])
      if (corner < 0 || corner >= count)
        refuse("triangle " + std::to_string(f) + " uses vertex " + std::to_string(corner) +
               ", but there are " + std::to_string(count));
}

}  // namespace io_detail

namespace {

using io_detail::append_little_endian;

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    const std::size_t taken = std::min<std::size_t>(3, bytes.size() - i);
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (k < taken ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) out += k <= taken ? digits[group >> (18 - 6 * k) & 63] : '=';
  }
  return out;
}

// The inline binary encoding of VTK: the number of bytes and then the bytes, encoded together in base64.
std::string inline_binary(const std::string& data) {
  std::string counted;
  append_little_endian(counted, static_cast<std::uint64_t>(data.size()));
  return base64(counted + data);
}

std::string data_array(const std::string& type, const std::string& attributes, const std::string& data) {
  return "        <DataArray type=\"" + type + "\" " + attributes + " format=\"binary\">\n          " +
         inline_binary(data) + "\n        </DataArray>\n";
}

std::string float_coordinates(const TriangleSoup& soup) {
  std::string bytes;
  bytes.reserve(12 * soup.points.size());
  for (const Vec3& p : soup.points)
    for (int k = 0; k < 3; ++k) append_little_endian(bytes, static_cast<float>(p[k]));
  return bytes;
}

std::string float_rows(const TriangleSoup& soup, std::span<const VertexScalar> scalars) {
  std::string bytes;
  bytes.reserve(4 * (3 + scalars.size()) * soup.points.size());
  for (std::size_t v = 0; v < soup.points.size(); ++v) {
    for (int k = 0; k < 3; ++k) append_little_endian(bytes, static_cast<float>(soup.points[v][k]));
    for (const VertexScalar& scalar : scalars)
      append_little_endian(bytes, static_cast<float>(scalar.values[v]));
  }
  return bytes;
}

}  // namespace

void write_ply(const std::filesystem::path& path, const TriangleSoup& soup, AnatomicalSpace space) {
  write_ply(path, soup, space, {});
}

void write_ply(const std::filesystem::path& path, const TriangleSoup& soup, AnatomicalSpace space,
               std::span<const VertexScalar> scalars) {
  io_detail::check_writable(path, soup);
  std::string properties;
  for (const VertexScalar& scalar : scalars) {
    if (scalar.values.size() != soup.points.size())
      throw InvalidInput("cannot write " + path.string() + ": " + scalar.name + " has " +
                         std::to_string(scalar.values.size()) + " values for " +
                         std::to_string(soup.points.size()) + " points");
    properties += "property float " + scalar.name + "\n";
  }
  std::string out =
      "ply\nformat binary_little_endian 1.0\ncomment SPACE=" + std::string(io_detail::name(space)) +
      "\nelement vertex " + std::to_string(soup.points.size()) +
      "\nproperty float x\nproperty float y\nproperty float z\n" + properties + "element face " +
      std::to_string(soup.triangles.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
  out += float_rows(soup, scalars);
  out.reserve(out.size() + 13 * soup.triangles.size());
  for (const auto& triangle : soup.triangles) {
    out += '\3';
    for (int corner : triangle) append_little_endian(out, static_cast<std::int32_t>(corner));
  }
  write_file(path, out);
}

void write_vtp(const std::filesystem::path& path, const TriangleSoup& soup, AnatomicalSpace space) {
  io_detail::check_writable(path, soup);
  std::string connectivity, offsets, tag;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
    for (int corner : soup.triangles[f])
      append_little_endian(connectivity, static_cast<std::int32_t>(corner));
    append_little_endian(offsets, static_cast<std::int32_t>(3 * (f + 1)));
  }
  for (char c : io_detail::name(space)) tag += std::to_string(static_cast<int>(c)) + " ";
  const std::string out =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
      "  <PolyData>\n    <FieldData>\n"
      "      <Array type=\"String\" Name=\"SPACE\" NumberOfTuples=\"1\" format=\"ascii\">\n        " +
      tag +
      "0\n      </Array>\n    </FieldData>\n"
      "    <Piece NumberOfPoints=\"" +
      std::to_string(soup.points.size()) +
      "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"" +
      std::to_string(soup.triangles.size()) + "\">\n      <Points>\n" +
      data_array("Float32", "Name=\"Points\" NumberOfComponents=\"3\"", float_coordinates(soup)) +
      "      </Points>\n      <Polys>\n" + data_array("Int32", "Name=\"connectivity\"", connectivity) +
      data_array("Int32", "Name=\"offsets\"", offsets) +
      "      </Polys>\n    </Piece>\n  </PolyData>\n</VTKFile>\n";
  write_file(path, out);
}

}  // namespace foramen
