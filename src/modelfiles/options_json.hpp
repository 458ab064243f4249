#pragma once
/// \file
/// Described options as JSON. The key of an option is its name with its unit.

#include <nlohmann/json.hpp>

#include "core/byte_archive.hpp"
#include "foramen/core/options.hpp"

namespace foramen {

template <DescribedOptions Options>
nlohmann::ordered_json described_json(const Options& options);

template <class Field>
nlohmann::ordered_json option_json(const Field& field) {
  if constexpr (std::is_enum_v<Field>) {
    return word_of(field);
  } else if constexpr (detail::is_optional<Field>) {
    return field ? option_json(*field) : nlohmann::ordered_json();
  } else if constexpr (detail::is_vector<Field>) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const auto& item : field)
      if constexpr (DescribedOptions<const typename Field::value_type>)
        list.push_back(described_json(item));
      else
        list.push_back(option_json(item));
    return list;
  } else {
    return field;
  }
}

/// The JSON pointer of the option with this path. The unit is a part of the last name.
inline nlohmann::ordered_json::json_pointer option_pointer(const std::string& path, const OptionText& text) {
  std::string place("/");
  place += name_with_unit(path, text.unit);
  for (char& c : place)
    if (c == '.') c = '/';
  return nlohmann::ordered_json::json_pointer(place);
}

/// A JSON object with an entry for every option. The options of a nested struct form an object of their own
/// if its description says so.
template <DescribedOptions Options>
nlohmann::ordered_json described_json(const Options& options) {
  nlohmann::ordered_json object = nlohmann::ordered_json::object();
  for_each_option(options, [&](const std::string& path, const auto& field, const OptionText& text) {
    object[option_pointer(path, text)] = option_json(field);
  });
  return object;
}

/// Sets every option from such an object. Throws nlohmann::json::exception if an option is missing or has
/// another type, and InvalidInput if a word is not one of the option's words. \pre the options have no lists
/// and no optional values
template <DescribedOptions Options>
void set_options(Options& options, const nlohmann::ordered_json& object) {
  for_each_option(options, [&](const std::string& path, auto& field, const OptionText& text) {
    using Field = std::remove_reference_t<decltype(field)>;
    const nlohmann::ordered_json& found = object.at(option_pointer(path, text));
    if constexpr (std::is_enum_v<Field>) {
      const auto word = found.template get<std::string>();
      const auto value = value_of<Field>(word);
      if (!value) throw InvalidInput(path + " is " + word + ", which is none of its values");
      field = *value;
    } else {
      field = found.template get<Field>();
    }
  });
}

}  // namespace foramen
