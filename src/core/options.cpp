#include "foramen/core/options.hpp"

#include <cstdio>

namespace foramen {

std::string name_with_unit(std::string_view name, std::string_view unit) {
  std::string text(name);
  if (unit.empty()) return text;
  text += '_';
  for (const char c : unit)
    if (c != '^') text += c;
  return text;
}

namespace detail {

void check_option(std::string_view where, std::string_view name, double value, const OptionText& text) {
  if (text.range.contains(value)) return;
  char number[32];
  std::snprintf(number, sizeof number, "%g", value);
  std::string message = std::string(where) + ": " + std::string(name) + " is " + number;
  if (!text.unit.empty()) message += " " + std::string(text.unit);
  throw InvalidInput(message + "; it must be " + text.range.text());
}

}  // namespace detail
}  // namespace foramen
