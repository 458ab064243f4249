#pragma once
/// \file
/// Structs as JSON objects and back. A struct names its fields once for both ways, in the order in which they
/// are written:
///
///     template <class Fields>
///     void list_fields(Fields& fields, MaybeConst<RunInput> auto& input) {
///       fields("file", input.file);
///       fields.if_there("label", input.label);
///     }
///
/// A field is a number, a text, an enumeration with EnumWords, a vector or matrix of Eigen, JSON as it is, a
/// struct with such a list, an optional or a std::vector of these, or a list of names and numbers, which is
/// an object. JSON has no word for a number that is not finite: it is null, and NaN when it is read.

#include <cmath>
#include <concepts>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include "core/byte_archive.hpp"
#include "foramen/core/error.hpp"
#include "foramen/core/options.hpp"

namespace foramen {

using NamedNumbers = std::vector<std::pair<std::string, double>>;

namespace detail {
template <class Value>
inline constexpr bool is_fixed_matrix = false;
template <class Number, int rows, int cols>
inline constexpr bool is_fixed_matrix<Eigen::Matrix<Number, rows, cols>> = true;
}  // namespace detail

template <class Value>
nlohmann::ordered_json json_of(const Value& value);

/// Collects the fields of a struct in an object.
class JsonFieldWriter {
 public:
  /// A field that every file has. An optional one is null where it is unset.
  template <class Value>
  void operator()(const char* name, const Value& value) {
    object_[name] = json_of(value);
  }
  /// A field that a file may lack. An optional one is left out where it is unset.
  template <class Value>
  void if_there(const char* name, const Value& value) {
    if constexpr (detail::is_optional<Value>) {
      if (value) object_[name] = json_of(*value);
    } else {
      object_[name] = json_of(value);
    }
  }
  /// The fields of a struct among the others. It is set if the object has a field of this name.
  template <class Struct>
  void inlined(const char* /*name*/, const std::optional<Struct>& part) {
    if (part) list_fields(*this, *part);
  }
  nlohmann::ordered_json take() { return std::move(object_); }

 private:
  nlohmann::ordered_json object_ = nlohmann::ordered_json::object();
};

template <class Value>
nlohmann::ordered_json json_of(const Value& value) {
  if constexpr (std::same_as<Value, nlohmann::ordered_json> || std::is_arithmetic_v<Value> ||
                std::same_as<Value, std::string>) {
    return value;
  } else if constexpr (std::is_enum_v<Value>) {
    return word_of(value);
  } else if constexpr (detail::is_optional<Value>) {
    return value ? json_of(*value) : nlohmann::ordered_json();
  } else if constexpr (std::same_as<Value, NamedNumbers>) {
    auto object = nlohmann::ordered_json::object();
    for (const auto& [name, number] : value) object[name] = number;
    return object;
  } else if constexpr (detail::is_vector<Value>) {
    auto list = nlohmann::ordered_json::array();
    for (const auto& item : value) list.push_back(json_of(item));
    return list;
  } else if constexpr (detail::is_fixed_matrix<Value>) {
    auto rows = nlohmann::ordered_json::array();
    for (Eigen::Index r = 0; r < value.rows(); ++r) {
      if constexpr (Value::ColsAtCompileTime == 1) {
        rows.push_back(value(r));
      } else {
        rows.push_back(nlohmann::ordered_json::array());
        for (Eigen::Index c = 0; c < value.cols(); ++c) rows.back().push_back(value(r, c));
      }
    }
    return rows;
  } else {
    JsonFieldWriter fields;
    list_fields(fields, value);
    return fields.take();
  }
}

/// JSON and its place in a file, such as shapes[3].status. Refuses what is none of the values it is asked
/// for: InvalidInput with the place.
class PlacedJson {
 public:
  PlacedJson(const nlohmann::ordered_json& json, std::string place) : json_(json), place_(std::move(place)) {}

  template <class Value>
  void read(Value& value) const;
  [[noreturn]] void refuse(const std::string& why) const {
    throw InvalidInput((place_.empty() ? "the whole" : place_) + " " + why);
  }
  bool has(const char* name) const { return json_.contains(name); }
  PlacedJson field(const std::string& name) const {
    PlacedJson inner(json_, place_.empty() ? name : place_ + "." + name);
    const auto found = json_.find(name);
    if (found == json_.end()) inner.refuse("is missing");
    return {*found, std::move(inner.place_)};
  }
  void require_object() const {
    if (!json_.is_object()) refuse("is no object");
  }

 private:
  PlacedJson item(std::size_t i) const { return {json_[i], place_ + "[" + std::to_string(i) + "]"}; }
  void require_items(std::size_t count) const {
    if (!json_.is_array() || json_.size() != count)
      refuse("is no list of " + std::to_string(count) + " values");
  }
  template <std::integral Value>
  Value whole_number() const {
    const bool fits = json_.is_number_unsigned()
                          ? std::in_range<Value>(json_.get<std::uint64_t>())
                          : json_.is_number_integer() && std::in_range<Value>(json_.get<std::int64_t>());
    if (!fits) refuse("is no whole number in its range");
    return json_.get<Value>();
  }
  double number() const {
    if (json_.is_null()) return std::numeric_limits<double>::quiet_NaN();
    if (!json_.is_number()) refuse("is no number");
    return json_.get<double>();
  }
  std::string text() const {
    if (!json_.is_string()) refuse("is no text");
    return json_.get<std::string>();
  }

  const nlohmann::ordered_json& json_;
  std::string place_;
};

/// Sets the fields of a struct from an object; the same calls as of JsonFieldWriter.
class JsonFieldReader {
 public:
  explicit JsonFieldReader(const PlacedJson& object) : object_(object) { object.require_object(); }
  template <class Value>
  void operator()(const char* name, Value& value) const {
    object_.field(name).read(value);
  }
  /// The value stays as it is where the file lacks it.
  template <class Value>
  void if_there(const char* name, Value& value) const {
    if (object_.has(name)) object_.field(name).read(value);
  }
  template <class Struct>
  void inlined(const char* name, std::optional<Struct>& part) {
    part.reset();
    if (object_.has(name)) list_fields(*this, part.emplace());
  }
  /// The whole object.
  nlohmann::ordered_json all() const {
    nlohmann::ordered_json object;
    object_.read(object);
    return object;
  }

 private:
  const PlacedJson& object_;
};

template <class Value>
void PlacedJson::read(Value& value) const {
  if constexpr (std::same_as<Value, nlohmann::ordered_json>) {
    value = json_;
  } else if constexpr (std::same_as<Value, std::string>) {
    value = text();
  } else if constexpr (std::integral<Value>) {
    value = whole_number<Value>();
  } else if constexpr (std::floating_point<Value>) {
    value = number();
  } else if constexpr (std::is_enum_v<Value>) {
    const auto found = value_of<Value>(text());
    if (!found) refuse("is " + json_.dump() + ", which is none of its words");
    value = *found;
  } else if constexpr (detail::is_optional<Value>) {
    value.reset();
    if (!json_.is_null()) read(value.emplace());
  } else if constexpr (std::same_as<Value, NamedNumbers>) {
    require_object();
    value.clear();
    for (const auto& [name, inner] : json_.items()) value.emplace_back(name, field(name).number());
  } else if constexpr (detail::is_vector<Value>) {
    if (!json_.is_array()) refuse("is no list");
    value.clear();
    for (std::size_t i = 0; i < json_.size(); ++i) item(i).read(value.emplace_back());
  } else if constexpr (detail::is_fixed_matrix<Value>) {
    require_items(static_cast<std::size_t>(value.rows()));
    for (Eigen::Index r = 0; r < value.rows(); ++r) {
      const PlacedJson row = item(static_cast<std::size_t>(r));
      if constexpr (Value::ColsAtCompileTime == 1) {
        row.read(value(r));
      } else {
        row.require_items(static_cast<std::size_t>(value.cols()));
        for (Eigen::Index c = 0; c < value.cols(); ++c)
          row.item(static_cast<std::size_t>(c)).read(value(r, c));
      }
    }
  } else {
    JsonFieldReader fields(*this);
    list_fields(fields, value);
  }
}

}  // namespace foramen
