#pragma once
/// \file
/// Flags of the command line made from described options (core/options.hpp).

#include <charconv>
#include <string>
#include <string_view>

#include "command.hpp"
#include "foramen/core/options.hpp"

namespace foramen::app {
namespace detail {

/// Refuses a number out of the option's range before the command begins.
inline CLI::Validator within(const OptionRange& range) {
  return CLI::Validator(
      [range](const std::string& text) {
        double value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        const bool is_number = error == std::errc() && end == text.data() + text.size();
        if (is_number && range.contains(value)) return std::string();
        return "the value " + text + " is not " + range.text();
      },
      range.text());
}

template <class Field>
CLI::Option* add_field(CLI::App& command, const std::string& flag, Field& field, const OptionText& text) {
  std::string help(text.meaning);
  if (!text.unit.empty()) help += " [" + std::string(text.unit) + "]";
  if constexpr (std::is_same_v<Field, bool>) {
    return command.add_flag(flag, field, help);
  } else if constexpr (std::is_enum_v<Field>) {
    std::map<std::string, Field> choices;
    for (const auto& [word, value] : EnumWords<Field>::all) choices.emplace(word, value);
    return add_choice<Field>(command, flag, field, choices, help);
  } else {
    CLI::Option* option = command.add_option(flag, field, help);
    if (!text.range.text().empty()) option->check(within(text.range));
    return option;
  }
}

}  // namespace detail

/// Adds the flag for the option of this path. Its help, its default and the check of its range come from the
/// description.
template <DescribedOptions Options>
CLI::Option* add_described(CLI::App& command, const std::string& flag, Options& options,
                           std::string_view path) {
  CLI::Option* added = nullptr;
  for_each_option(options, [&](const std::string& at, auto& field, const OptionText& text) {
    using Field = std::remove_reference_t<decltype(field)>;
    if constexpr (!foramen::detail::is_vector<Field>)
      if (at == path) added = detail::add_field(command, flag, field, text);
  });
  FORAMEN_ASSERT(added != nullptr);
  return added;
}

}  // namespace foramen::app
