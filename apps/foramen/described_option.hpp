#pragma once
/// \file
/// Flags of the command line made from described options (core/options.hpp).

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "command.hpp"
#include "foramen/core/options.hpp"

namespace foramen::app {
namespace detail {

/// Refuses what is no number, or a number out of the option's range, before the command begins.
template <class Number>
CLI::Validator within(const OptionRange& range) {
  return CLI::Validator(
      [range](const std::string& text) {
        Number value{};
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        const bool is_number = error == std::errc() && end == text.data() + text.size();
        const bool bounded = !range.text().empty();
        if (is_number && (!bounded || range.contains(static_cast<double>(value)))) return std::string();
        std::string expected = std::is_integral_v<Number> ? "a whole number" : "a number";
        if (std::is_unsigned_v<Number>) expected += " of 0 or more";
        if (bounded) expected += " " + range.text();
        return "the value " + text + " is not " + expected;
      },
      range.text());
}

template <class Field>
struct ValueOf {
  using Type = Field;
};
template <class Value>
struct ValueOf<std::optional<Value>> {
  using Type = Value;
};

template <class Field>
CLI::Option* add_field(CLI::App& command, const std::string& flag, Field& field, const OptionText& text) {
  using Value = typename ValueOf<Field>::Type;
  std::string help(text.meaning);
  if (!text.unit.empty()) help += " [" + std::string(text.unit) + "]";
  if constexpr (std::is_same_v<Value, bool>) {
    return command.add_flag(flag, field, help);
  } else if constexpr (std::is_enum_v<Value>) {
    std::map<std::string, Field> choices;
    for (const auto& [word, value] : EnumWords<Value>::all) choices.emplace(word, value);
    return add_choice<Field>(command, flag, field, choices, help);
  } else {
    CLI::Option* option = command.add_option(flag, field, help);
    if constexpr (std::is_arithmetic_v<Value>) option->check(within<Value>(text.range));
    return option;
  }
}

/// The text that the help shows as the default of an option that may be unset.
template <class Field>
std::string shown_default(const Field& field) {
  if constexpr (foramen::detail::is_optional<Field>) {
    return field ? shown_default(*field) : std::string();
  } else if constexpr (std::is_enum_v<Field>) {
    return std::string(word_of(field));
  } else if constexpr (std::is_same_v<Field, std::string>) {
    return field;
  } else {
    return CLI::detail::to_string(field);
  }
}

}  // namespace detail

/// "target_error" as "--target-error".
inline std::string flag_of(std::string_view name) {
  std::string flag = "--" + std::string(name);
  std::replace(flag.begin() + 2, flag.end(), '_', '-');
  return flag;
}

/// Adds a flag for every choice of a struct whose options may be unset. The flag has the name of the choice.
/// As the default, the help shows the value of the choice if it is already set, and otherwise the value in
/// `defaults`.
template <DescribedOptions Choices>
std::map<std::string, CLI::Option*> add_choices(CLI::App& command, Choices& choices,
                                                const Choices& defaults) {
  std::map<std::string, std::string> shown;
  const auto show = [&](const std::string& path, const auto& field, const OptionText&) {
    if (const std::string text = detail::shown_default(field); !text.empty()) shown[path] = text;
  };
  for_each_option(defaults, show);
  for_each_option(std::as_const(choices), show);
  std::map<std::string, CLI::Option*> added;
  for_each_option(choices, [&](const std::string& path, auto& field, const OptionText& text) {
    CLI::Option* option = detail::add_field(command, flag_of(path), field, text);
    using Field = std::remove_reference_t<decltype(field)>;
    if constexpr (!std::is_same_v<Field, bool>) option->default_str(shown[path]);
    added.emplace(path, option);
  });
  return added;
}

/// Adds the flag for the option with this path. Its help, its default and the check of its range come from
/// the description.
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
