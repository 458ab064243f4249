#pragma once
/// \file
/// Sets described options (core/options.hpp) from Python's dicts, and lists their descriptions.

#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "bindings.hpp"
#include "foramen/core/options.hpp"

namespace foramen::python {
namespace detail {

/// Throws Python's TypeError: "OPTION must be WHAT, not TYPE".
[[noreturn]] void wrong_type(const std::string& option, const char* what, py::handle given);
/// The word in a string or in a member of an enumeration of strings, in lower case.
std::string word_from(py::handle given, const std::string& option);
bool bool_from(py::handle given, const std::string& option);
double number_from(py::handle given, const std::string& option);
/// The integer. Throws InvalidInput for a number outside least .. most.
std::int64_t integer_from(py::handle given, const std::string& option, std::int64_t least);
std::uint64_t unsigned_from(py::handle given, const std::string& option);
std::string string_from(py::handle given, const std::string& option);
/// The path that equals the given text or ends with it. Throws InvalidInput if there is no such path or more
/// than one; the message names similar paths.
std::string path_meant(const std::string& given, const std::vector<std::string>& paths);
/// Whether the value is a dict, which sets the options of a struct.
bool is_dict(py::handle given);

template <class Field>
void set_field(Field& field, py::handle given, const std::string& option);

template <DescribedOptions Options>
void set_fields(Options& options, const py::dict& given) {
  std::vector<std::string> paths;
  for_each_option(options,
                  [&](const std::string& path, const auto&, const OptionText&) { paths.push_back(path); });
  for (const auto& [key, value] : given) {
    const std::string wanted = path_meant(string_from(key, "an option's name"), paths);
    for_each_option(options,
                    [&, given_value = value](const std::string& path, auto& field, const OptionText&) {
                      if (path == wanted) set_field(field, given_value, path);
                    });
  }
}

// A struct that is an element of a list. It is given as a dict, or as a sequence of its numbers in their
// order.
template <DescribedOptions Options>
void set_item(Options& item, py::handle given, const std::string& option) {
  if (is_dict(given)) return set_fields(item, py::reinterpret_borrow<py::dict>(given));
  if (!py::isinstance<py::sequence>(given) || py::isinstance<py::str>(given))
    wrong_type(option, "a list of dicts or of sequences", given);
  const auto values = py::reinterpret_borrow<py::sequence>(given);
  std::size_t next = 0;
  for_each_option(item, [&](const std::string& path, auto& field, const OptionText&) {
    if (next < values.size()) set_field(field, py::object(values[next]), option + "." + path);
    ++next;
  });
  if (next != values.size())
    throw InvalidInput(option + " has items of " + std::to_string(next) + " values; one has " +
                       std::to_string(values.size()));
}

template <class Field>
void set_field(Field& field, py::handle given, const std::string& option) {
  if constexpr (foramen::detail::is_optional<Field>) {
    if (given.is_none()) {
      field.reset();
    } else {
      typename Field::value_type value{};
      set_field(value, given, option);
      field = std::move(value);
    }
  } else if constexpr (foramen::detail::is_vector<Field>) {
    if (!py::isinstance<py::sequence>(given) || py::isinstance<py::str>(given))
      wrong_type(option, "a list", given);
    Field values;
    for (const py::handle item : py::reinterpret_borrow<py::sequence>(given)) {
      typename Field::value_type value{};
      if constexpr (DescribedOptions<typename Field::value_type>)
        set_item(value, item, option);
      else
        set_field(value, item, option);
      values.push_back(std::move(value));
    }
    field = std::move(values);
  } else if constexpr (std::is_same_v<Field, bool>) {
    field = bool_from(given, option);
  } else if constexpr (std::is_enum_v<Field>) {
    const std::string word = word_from(given, option);
    const auto value = value_of<Field>(word);
    if (!value) {
      std::string words;
      for (const auto& [known, meaning] : EnumWords<Field>::all)
        words += (words.empty() ? "" : ", ") + std::string(known);
      throw InvalidInput(option + " must be one of " + words + ", not " + word);
    }
    field = *value;
  } else if constexpr (std::is_floating_point_v<Field>) {
    field = number_from(given, option);
  } else if constexpr (std::is_unsigned_v<Field>) {
    static_assert(std::is_same_v<Field, std::uint64_t>);
    field = unsigned_from(given, option);
  } else if constexpr (std::is_integral_v<Field>) {
    static_assert(std::is_same_v<Field, int>);
    field = static_cast<int>(integer_from(given, option, std::numeric_limits<int>::min()));
  } else {
    static_assert(std::is_same_v<Field, std::string>);
    field = string_from(given, option);
  }
}

template <class Field>
py::object python_value(const Field& field) {
  if constexpr (foramen::detail::is_optional<Field>) {
    return field ? python_value(*field) : py::none();
  } else if constexpr (foramen::detail::is_vector<Field>) {
    py::list list;
    for (const auto& item : field) list.append(python_value(item));
    return list;
  } else if constexpr (DescribedOptions<const Field>) {
    py::dict dict;
    for_each_option(field, [&](const std::string& path, const auto& value, const OptionText&) {
      dict[py::str(path)] = python_value(value);
    });
    return dict;
  } else if constexpr (std::is_enum_v<Field>) {
    return py::str(std::string(word_of(field)));
  } else {
    return py::cast(field);
  }
}

template <class Field>
const char* kind_of() {
  if constexpr (foramen::detail::is_optional<Field>)
    return kind_of<typename Field::value_type>();
  else if constexpr (foramen::detail::is_vector<Field>)
    return DescribedOptions<const typename Field::value_type> ? "list of dict" : "list of float";
  else if constexpr (std::is_same_v<Field, bool>)
    return "bool";
  else if constexpr (std::is_enum_v<Field> || std::is_same_v<Field, std::string>)
    return "str";
  else
    return std::is_floating_point_v<Field> ? "float" : "int";
}

template <class Field>
py::tuple words_of() {
  if constexpr (foramen::detail::is_optional<Field>) {
    return words_of<typename Field::value_type>();
  } else if constexpr (std::is_enum_v<Field>) {
    py::list words;
    for (const auto& [word, value] : EnumWords<Field>::all) words.append(py::str(std::string(word)));
    return py::tuple(words);
  } else {
    return py::tuple();
  }
}

}  // namespace detail

/// Sets the options in a dict. Its keys are the paths of options, or the last parts of paths if no other
/// option ends with them. Throws TypeError for a value of a wrong type, and InvalidInput for an unknown
/// option and for a value out of its range. \param where  the name of the function, for messages
template <DescribedOptions Options>
void set_options(Options& options, const py::dict& given, const char* where) {
  detail::set_fields(options, given);
  check_options(where, options);
}

/// A tuple for every option: path, kind, unit, default, range, words, meaning.
template <DescribedOptions Options>
py::list listed_options(const Options& defaults) {
  py::list list;
  for_each_option(defaults, [&](const std::string& path, const auto& field, const OptionText& text) {
    using Field = std::remove_cvref_t<decltype(field)>;
    list.append(py::make_tuple(path, detail::kind_of<Field>(), std::string(text.unit),
                               detail::python_value(field), text.range.text(), detail::words_of<Field>(),
                               std::string(text.meaning)));
  });
  return list;
}

}  // namespace foramen::python
