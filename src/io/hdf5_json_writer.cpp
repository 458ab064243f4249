#include <charconv>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include "foramen/core/error.hpp"
#include "io/hdf5_json_file.hpp"
#include "io/json_text.hpp"
#include "io/sha256.hpp"

namespace foramen {
namespace {

using io_detail::json_text;

constexpr const char* scalar_shape = R"({"class":"H5S_SCALAR"})";
constexpr const char* text_type =
    R"({"class":"H5T_STRING","charSet":"H5T_CSET_UTF8","strPad":"H5T_STR_NULLPAD","length":"H5T_VARIABLE"})";

std::string simple_shape(std::initializer_list<std::size_t> sizes) {
  std::string text = R"({"class":"H5S_SIMPLE","dims":[)";
  for (std::size_t size : sizes) {
    if (!text.ends_with('[')) text += ',';
    text += std::to_string(size);
  }
  return text + "]}";
}

template <class T>
std::string number_type() {
  if (std::is_integral_v<T>) return R"({"class":"H5T_INTEGER","base":"H5T_STD_I32LE"})";
  return std::string(R"({"class":"H5T_FLOAT","base":"H5T_IEEE_F)") + (sizeof(T) == 4 ? "32" : "64") + "LE\"}";
}

// The shortest text that reads back as the same T.
template <class T>
void append_number(std::string& out, T value) {
  if constexpr (std::is_floating_point_v<T>) {
    if (!(std::abs(value) <= std::numeric_limits<T>::max()))
      throw InvalidInput("a number that is not finite has no place in JSON");
  }
  std::array<char, 32> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  FORAMEN_ASSERT(result.ec == std::errc());
  out.append(buffer.data(), result.ptr);
}

template <class T>
void append_list(std::string& out, std::span<const T> values) {
  out += '[';
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0) out += ',';
    append_number(out, values[i]);
  }
  out += ']';
}

// A UUID of 8-4-4-4-12 hexadecimal digits made from a hash of the path. UUID version 8 leaves the meaning of
// the digits to the writer.
std::string identifier(const std::string& path) {
  const std::string hash = sha256("foramen hdf5-json " + path).substr(0, 32);
  return hash.substr(0, 8) + "-" + hash.substr(8, 4) + "-8" + hash.substr(13, 3) + "-a" + hash.substr(17, 3) +
         "-" + hash.substr(20, 12);
}

std::string parent_of(const std::string& path) { return path.substr(0, path.rfind('/')); }
std::string name_of(const std::string& path) { return path.substr(path.rfind('/') + 1); }

}  // namespace

H5JsonWriter::H5JsonWriter() { objects_[""]; }

void H5JsonWriter::group(const std::string& path) {
  FORAMEN_ASSERT(path.starts_with('/'));
  const std::string parent = parent_of(path);
  if (!objects_.contains(parent)) group(parent);
  FORAMEN_ASSERT(objects_.at(parent).is_group);
  objects_[path];
}

void H5JsonWriter::dataset(const std::string& path, Object object) {
  group(path);
  objects_[path] = std::move(object);
}

template <class T>
void H5JsonWriter::scalar(const std::string& path, T value) {
  Object object{false, scalar_shape, number_type<T>(), {}, {}};
  append_number(object.value, value);
  dataset(path, std::move(object));
}

template <class T>
void H5JsonWriter::vector(const std::string& path, std::span<const T> values) {
  Object object{false, simple_shape({values.size()}), number_type<T>(), {}, {}};
  append_list(object.value, values);
  dataset(path, std::move(object));
}

template <class T>
void H5JsonWriter::matrix(const std::string& path, const H5Matrix<T>& values) {
  if (values.values.size() != values.rows * values.cols)
    throw InvalidInput(path + ": has not rows * columns values");
  Object object{false, simple_shape({values.rows, values.cols}), number_type<T>(), "[", {}};
  for (std::size_t row = 0; row < values.rows; ++row) {
    if (row > 0) object.value += ',';
    append_list(object.value, std::span<const T>(values.values).subspan(row * values.cols, values.cols));
  }
  object.value += ']';
  dataset(path, std::move(object));
}

void H5JsonWriter::string(const std::string& path, std::string_view text) {
  dataset(path, {false, scalar_shape, text_type, json_text(text), {}});
}

void H5JsonWriter::attribute(const std::string& path, const std::string& name, std::string_view text) {
  const auto object = objects_.find(path);
  FORAMEN_ASSERT(object != objects_.end() && object->second.is_group);
  object->second.attributes.push_back("{\"name\":" + json_text(name) + ",\"type\":" + text_type +
                                      ",\"shape\":" + scalar_shape + ",\"value\":" + json_text(text) + "}");
}

std::string H5JsonWriter::text() const {
  std::map<std::string, std::string> links;  // of each group
  for (const auto& [path, object] : objects_) {
    if (path.empty()) continue;
    std::string& list = links[parent_of(path)];
    list += (list.empty() ? "" : ",") + std::string(R"({"class":"H5L_TYPE_HARD","collection":")") +
            (object.is_group ? "groups" : "datasets") + R"(","id":")" + identifier(path) + R"(","title":)" +
            json_text(name_of(path)) + "}";
  }
  std::string groups, datasets;
  for (const auto& [path, object] : objects_) {
    std::string& out = object.is_group ? groups : datasets;
    out += (out.empty() ? "\n\"" : ",\n\"") + identifier(path) + R"(":{"alias":[)" +
           json_text(path.empty() ? "/" : path) + "],";
    if (object.is_group) {
      out += "\"attributes\":[";
      for (std::size_t i = 0; i < object.attributes.size(); ++i)
        out += (i > 0 ? "," : "") + object.attributes[i];
      out += "],\"links\":[" + links[path] + "]}";
    } else {
      out += "\"shape\":" + object.shape + ",\"type\":" + object.type + ",\"value\":" + object.value + "}";
    }
  }
  return "{\"apiVersion\":\"1.0.0\",\n\"root\":\"" + identifier("") + "\",\n\"groups\":{" + groups +
         "},\n\"datasets\":{" + datasets + "}}\n";
}

template void H5JsonWriter::scalar(const std::string&, float);
template void H5JsonWriter::scalar(const std::string&, double);
template void H5JsonWriter::scalar(const std::string&, std::int32_t);
template void H5JsonWriter::vector(const std::string&, std::span<const float>);
template void H5JsonWriter::vector(const std::string&, std::span<const double>);
template void H5JsonWriter::vector(const std::string&, std::span<const std::int32_t>);
template void H5JsonWriter::matrix(const std::string&, const H5Matrix<float>&);
template void H5JsonWriter::matrix(const std::string&, const H5Matrix<double>&);
template void H5JsonWriter::matrix(const std::string&, const H5Matrix<std::int32_t>&);

}  // namespace foramen
