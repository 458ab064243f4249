#pragma once
/// \file
/// Units of length of input files. Inside foramen every length is in millimetres.

#include <optional>
#include <string>
#include <string_view>

namespace foramen {

enum class LengthUnit { millimetre, centimetre, metre, micrometre };

/// The unit in which the lengths of input files are, as a user gives it.
struct InputUnit {
  /// Surfaces are refused if no vertebra has their size in this unit.
  InputUnit(LengthUnit unit = LengthUnit::millimetre) : length(unit) {}
  InputUnit(LengthUnit unit, bool is_certain) : length(unit), certain(is_certain) {}

  LengthUnit length;
  bool certain = false;  ///< a surface that is the size of no vertebra is used all the same, with a note
  friend bool operator==(const InputUnit&, const InputUnit&) = default;
};
/// The unit for what a user gave. Unset means mm. If mm is given, it is certain, because nobody would name
/// the default without a reason; any other unit is still checked by the sizes of the surfaces.
InputUnit input_unit(std::optional<LengthUnit> given);

/// The length of one unit in mm.
double millimetres_per(LengthUnit unit);
/// "mm", "cm", "m", "um".
std::string_view name(LengthUnit unit);
/// The unit of that name; nullopt if there is none.
std::optional<LengthUnit> length_unit(std::string_view name);
/// The unit in which a bounding-box diagonal of this number would be plausible for a vertebra, that is 20 to
/// 250 mm; nullopt if there is none or if that unit is mm.
std::optional<LengthUnit> likely_unit(double diagonal);

/// Plausible bounding-box diagonal of one vertebra, mm.
inline constexpr double smallest_diagonal_mm = 20, largest_diagonal_mm = 250;

}  // namespace foramen
