#pragma once
/// \file
/// A concept for function templates that accept both T& and const T&, to change the value or only to read it.

#include <concepts>
#include <type_traits>

namespace foramen {

/// `Value` is T or const T.
template <class Value, class T>
concept MaybeConst = std::same_as<std::remove_const_t<Value>, T>;

}  // namespace foramen
