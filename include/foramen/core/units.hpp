#pragma once
/// \file
/// Units of length of input files. Inside foramen every length is in millimetres.

#include <optional>
#include <string>
#include <string_view>

namespace foramen {

enum class LengthUnit { millimetre, centimetre, metre, micrometre };

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
