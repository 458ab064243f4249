#include "foramen/core/units.hpp"

#include <array>

namespace foramen {
namespace {

struct UnitRow {
  LengthUnit unit;
  std::string_view name;
  double millimetres;
};

constexpr std::array<UnitRow, 4> units{{{LengthUnit::millimetre, "mm", 1.0},
                                        {LengthUnit::centimetre, "cm", 10.0},
                                        {LengthUnit::metre, "m", 1000.0},
                                        {LengthUnit::micrometre, "um", 0.001}}};

}  // namespace

InputUnit input_unit(std::optional<LengthUnit> given) {
  return given ? InputUnit(*given, *given == LengthUnit::millimetre) : InputUnit();
}

double millimetres_per(LengthUnit unit) { return units[static_cast<std::size_t>(unit)].millimetres; }

std::string_view name(LengthUnit unit) { return units[static_cast<std::size_t>(unit)].name; }

std::optional<LengthUnit> length_unit(std::string_view name) {
  for (const UnitRow& row : units)
    if (row.name == name) return row.unit;
  return std::nullopt;
}

std::optional<LengthUnit> likely_unit(double diagonal) {
  for (const UnitRow& row : units) {
    const double mm = diagonal * row.millimetres;
    if (mm >= smallest_diagonal_mm && mm <= largest_diagonal_mm)
      return row.unit == LengthUnit::millimetre ? std::nullopt : std::optional(row.unit);
  }
  return std::nullopt;
}

}  // namespace foramen
