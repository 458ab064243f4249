#pragma once
/// \file
/// Converts values to bytes and back without loss. The bytes depend on the version of the program and the
/// byte order of the machine, so they serve for stored results that the same program reads again, never for
/// exchange.
///
/// A type lists its fields once, for writing and for reading, in a function transfer() that stands beside the
/// code that stores it:
///
///     template <class Archive>
///     void transfer(Archive& archive, MaybeConst<TorusMap> auto& map) {
///       archive(map.lattice, map.turns, map.jumps);
///     }

#include <array>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/core/ids.hpp"
#include "foramen/core/mesh.hpp"
#include "foramen/core/options.hpp"

namespace foramen {

/// Appends values to a string of bytes.
class ByteWriter {
 public:
  static constexpr bool reads = false;
  template <class... Values>
  void operator()(const Values&... values) {
    (transfer(*this, values), ...);
  }
  void floating(double value) { bytes_.append(reinterpret_cast<const char*>(&value), sizeof value); }
  /// Writes a variable-length integer: seven bits per byte, with the sign in the lowest bit. Most stored
  /// integers are small, so most take one byte.
  void integer(std::int64_t value) {
    auto bits = (static_cast<std::uint64_t>(value) << 1) ^ static_cast<std::uint64_t>(value >> 63);
    for (; bits >= 0x80; bits >>= 7) bytes_ += static_cast<char>(bits | 0x80);
    bytes_ += static_cast<char>(bits);
  }
  void raw(std::string_view bytes) { bytes_ += bytes; }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// Reads values from bytes in the order in which they were written. Throws InternalError if the bytes end too
/// early or hold an impossible value, since only foramen itself writes such bytes.
class ByteReader {
 public:
  static constexpr bool reads = true;
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}
  template <class... Values>
  void operator()(Values&... values) {
    (transfer(*this, values), ...);
  }
  double floating() {
    double value = 0;
    std::memcpy(&value, raw(sizeof value).data(), sizeof value);
    return value;
  }
  std::int64_t integer() {
    std::uint64_t bits = 0;
    for (unsigned shift = 0;; shift += 7) {
      FORAMEN_ASSERT(shift < 64);
      const auto byte = static_cast<unsigned char>(raw(1).front());
      bits |= static_cast<std::uint64_t>(byte & 0x7f) << shift;
      if (byte < 0x80) break;
    }
    return static_cast<std::int64_t>(bits >> 1) ^ -static_cast<std::int64_t>(bits & 1);
  }
  std::string_view raw(std::size_t count) {
    FORAMEN_ASSERT(count <= bytes_.size());
    const std::string_view taken = bytes_.substr(0, count);
    bytes_.remove_prefix(count);
    return taken;
  }
  /// Reads the number of items that follow. Each item takes at least one byte, so a number above the bytes
  /// that are left is refused before memory is allocated.
  std::size_t count() {
    const std::int64_t items = integer();
    FORAMEN_ASSERT(items >= 0 && static_cast<std::uint64_t>(items) <= bytes_.size());
    return items;
  }
  bool at_end() const { return bytes_.empty(); }

 private:
  std::string_view bytes_;
};

/// Writes one value to bytes.
template <class Value>
std::string to_bytes(const Value& value) {
  ByteWriter writer;
  writer(value);
  return writer.take();
}

/// Reads one value from the bytes of to_bytes(). Throws InternalError if bytes are left over.
template <class Value>
Value from_bytes(std::string_view bytes) {
  Value value;
  ByteReader reader(bytes);
  reader(value);
  FORAMEN_ASSERT(reader.at_end());
  return value;
}

template <class Archive, class Number>
requires std::is_arithmetic_v<Number> || std::is_enum_v<Number>
void transfer(Archive& archive, Number& number) {
  using Value = std::remove_const_t<Number>;
  if constexpr (std::is_floating_point_v<Value> && Archive::reads)
    number = static_cast<Value>(archive.floating());
  else if constexpr (std::is_floating_point_v<Value>)
    archive.floating(static_cast<double>(number));
  else if constexpr (Archive::reads)
    number = static_cast<Value>(archive.integer());
  else
    archive.integer(static_cast<std::int64_t>(number));
}

template <class Archive, class Tag>
void transfer(Archive& archive, Id<Tag>& id) {
  archive(id.index);
}
template <class Archive, class Tag>
void transfer(Archive& archive, const Id<Tag>& id) {
  archive(id.index);
}

template <class Archive>
void transfer(Archive& archive, MaybeConst<std::string> auto& text) {
  if constexpr (Archive::reads) {
    text = archive.raw(archive.count());
  } else {
    archive.integer(std::ssize(text));
    archive.raw(text);
  }
}

namespace detail {
template <class T>
inline constexpr bool is_array = false;
template <class T, std::size_t n>
inline constexpr bool is_array<std::array<T, n>> = true;
template <class T>
inline constexpr bool is_id_map = false;
template <class I, class T>
inline constexpr bool is_id_map<IdMap<I, T>> = true;
template <class T>
concept EigenMatrix = std::derived_from<T, Eigen::PlainObjectBase<T>>;
}  // namespace detail

template <class Archive, class Values>
requires detail::is_vector<std::remove_const_t<Values>>
void transfer(Archive& archive, Values& values) {
  if constexpr (Archive::reads)
    values.resize(archive.count());
  else
    archive.integer(std::ssize(values));
  for (auto& value : values) archive(value);
}

template <class Archive, class Values>
requires detail::is_array<std::remove_const_t<Values>>
void transfer(Archive& archive, Values& values) {
  for (auto& value : values) archive(value);
}

template <class Archive, class Value>
requires detail::is_optional<std::remove_const_t<Value>>
void transfer(Archive& archive, Value& value) {
  bool present = value.has_value();
  archive(present);
  if constexpr (Archive::reads) {
    value.reset();
    if (present) value.emplace();
  }
  if (present) archive(*value);
}

template <class Archive, class Map>
requires detail::is_id_map<std::remove_const_t<Map>>
void transfer(Archive& archive, Map& map) { archive(map.values()); }

template <class Archive, class Matrix>
requires detail::EigenMatrix<std::remove_const_t<Matrix>>
void transfer(Archive& archive, Matrix& matrix) {
  using Fixed = std::remove_const_t<Matrix>;
  if constexpr (Fixed::SizeAtCompileTime == Eigen::Dynamic) {
    Eigen::Index rows = matrix.rows(), cols = matrix.cols();
    archive(rows, cols);
    if constexpr (Archive::reads) matrix.resize(rows, cols);
  }
  for (Eigen::Index k = 0; k < matrix.size(); ++k) archive(*(matrix.data() + k));
}

template <class Archive>
void transfer(Archive& archive, MaybeConst<RigidTransform> auto& motion) {
  archive(motion.matrix());
}

template <class Archive>
void transfer(Archive& archive, MaybeConst<TriangleSoup> auto& soup) {
  archive(soup.points, soup.triangles);
}

/// A mesh is stored as its points and triangles; reading builds the connectivity again. An empty mesh stays
/// empty.
inline void transfer(ByteWriter& archive, const Mesh& mesh) { archive(mesh.soup()); }
inline void transfer(ByteReader& archive, Mesh& mesh) {
  TriangleSoup soup;
  archive(soup);
  mesh = build_mesh(std::move(soup));
}

}  // namespace foramen
