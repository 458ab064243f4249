#pragma once
/// \file
/// Descriptions of options: name, unit, range and meaning, written once. The command line and its help,
/// run.json, the Python keywords and the keys of stored results are all derived from them.
///
/// Beside every struct of options stands a function describe() that visits its fields in the order in which
/// they are shown:
///
///     struct SurfaceTargetsOptions {
///       double reach_mm = 4;
///     };
///     template <class Visitor>
///     void describe(Visitor& visit, MaybeConst<SurfaceTargetsOptions> auto& o) {
///       visit(o.reach_mm, {.name = "reach", .unit = "mm", .range = above(0), .meaning = "..."});
///     }
///
/// A field is a number, a bool, a string, an enumeration with EnumWords, an optional or a vector of these, a
/// described struct, or a vector of described structs. A test counts the fields of every described struct, so
/// that describe() cannot leave one out.

#include <concepts>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "foramen/core/error.hpp"

namespace foramen {

/// `Value` is T or const T: for templates that accept both, to change the value or only to read it.
template <class Value, class T>
concept MaybeConst = std::same_as<std::remove_const_t<Value>, T>;

namespace detail {
template <class T>
inline constexpr bool is_vector = false;
template <class T>
inline constexpr bool is_vector<std::vector<T>> = true;
template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;
}  // namespace detail

/// An interval of numbers, open or closed at either end. By default it contains every number.
struct OptionRange {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  bool least_excluded = false, most_excluded = false;

  /// The same interval with a closed upper end; below() gives an open one.
  constexpr OptionRange up_to(double limit) const { return {least, limit, least_excluded, false}; }
  constexpr OptionRange below(double limit) const { return {least, limit, least_excluded, true}; }

  /// Whether it contains the value; no interval contains NaN.
  bool contains(double value) const;
  /// "> 0", "at least 1", "in (0, 1]"; empty for every number.
  std::string text() const;
};

constexpr OptionRange above(double limit) { return {.least = limit, .least_excluded = true}; }
constexpr OptionRange at_least(double limit) { return {.least = limit}; }

/// How the names of the options in a nested struct are formed.
enum class Nesting {
  object,    ///< outer.inner
  prefixed,  ///< outer_inner
  inlined    ///< inner
};

/// The description of one option.
struct OptionText {
  std::string_view name = {};  ///< in snake_case, without the unit
  std::string_view unit = {};  ///< "mm", "mm^2", "medians" ...; empty: a pure number or no number
  OptionRange range = {};      ///< of the number, or of every number of a list
  /// What the option decides, in one phrase for the user, without unit, range and default.
  std::string_view meaning = {};
  Nesting nesting = Nesting::object;  ///< of a described struct
};

/// The words that stand for the values of an enumeration; specialised beside the enumeration:
///
///     template <>
///     struct EnumWords<Bending> {
///       static constexpr std::pair<std::string_view, Bending> all[] = {{"rigid", Bending::rigid}, ...};
///     };
template <class Enum>
struct EnumWords;

/// The word of a value. Throws InternalError if the value has none.
template <class Enum>
std::string_view word_of(Enum value) {
  for (const auto& [word, meaning] : EnumWords<Enum>::all)
    if (meaning == value) return word;
  throw InternalError("a value of an enumeration has no word");
}

/// The value of a word; nullopt if no value has this word.
template <class Enum>
std::optional<Enum> value_of(std::string_view wanted) {
  for (const auto& [word, value] : EnumWords<Enum>::all)
    if (word == wanted) return value;
  return std::nullopt;
}

namespace detail {
struct AnyVisitor {
  void operator()(auto& field, const OptionText& text);
};
}  // namespace detail

/// A struct for which describe() exists.
template <class T>
concept DescribedOptions = std::is_class_v<std::remove_const_t<T>> &&
    requires(detail::AnyVisitor& visitor, T& options) {
  describe(visitor, options);
};

/// Calls use(path, field, text) for every option of a struct and of its nested structs. The path is the full
/// name of the option, e.g. "group.template_vertices".
template <DescribedOptions Options, class Use>
void for_each_option(Options& options, const Use& use, const std::string& prefix = {}) {
  const auto visit = [&](auto& field, const OptionText& text) {
    std::string path = prefix;
    if (text.nesting != Nesting::inlined) path += text.name;
    if constexpr (DescribedOptions<std::remove_reference_t<decltype(field)>>) {
      if (text.nesting == Nesting::object) path += '.';
      if (text.nesting == Nesting::prefixed) path += '_';
      for_each_option(field, use, path);
    } else {
      use(path, field, text);
    }
  };
  describe(visit, options);
}

/// Name and unit: "reach_mm", "lambda_mm2", "rejection_medians"; the name alone without a unit.
std::string name_with_unit(std::string_view name, std::string_view unit);

namespace detail {
/// Throws InvalidInput unless the number is in the range.
void check_option(std::string_view where, std::string_view name, double value, const OptionText& text);
}  // namespace detail

/// Throws InvalidInput for the first number out of its range; the message names the option, its value and its
/// range.
/// \param where  name of the function to which the options were passed; for the message
template <DescribedOptions Options>
void check_options(std::string_view where, const Options& options) {
  for_each_option(options, [&](const std::string& path, const auto& field, const OptionText& text) {
    using Field = std::remove_cvref_t<decltype(field)>;
    if constexpr (std::is_arithmetic_v<Field> && !std::is_same_v<Field, bool>) {
      detail::check_option(where, path, static_cast<double>(field), text);
    } else if constexpr (detail::is_optional<Field>) {
      if constexpr (std::is_arithmetic_v<typename Field::value_type>)
        if (field) detail::check_option(where, path, static_cast<double>(*field), text);
    } else if constexpr (detail::is_vector<Field>) {
      for (const auto& item : field)
        if constexpr (DescribedOptions<const typename Field::value_type>)
          check_options(where, item);
        else if constexpr (std::is_arithmetic_v<typename Field::value_type>)
          detail::check_option(where, path, static_cast<double>(item), text);
    }
  });
}

}  // namespace foramen
