#pragma once
/// \file
/// Properties of types that function templates ask for.

#include <concepts>
#include <optional>
#include <type_traits>
#include <vector>

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

}  // namespace foramen
