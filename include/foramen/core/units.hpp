#pragma once
/// \file
/// Units of length of input files. Inside foramen every length is in millimetres.

#include <optional>
#include <string>
#include <string_view>

namespace foramen {

enum class LengthUnit { millimetre, centimetre, metre, micrometre };

double millimetres_per(LengthUnit unit);
/// "mm", "cm", "m", "um".
std::string_view name(LengthUnit unit);
/// The unit of that name; empty if there is none.
std::optional<LengthUnit> length_unit(std::string_view name);
/// The unit in which a vertebra of this bounding-box diagonal would be 20 to 250 mm; empty if none does or if
/// it is mm.
std::optional<LengthUnit> likely_unit(double diagonal);

/// Plausible bounding-box diagonal of one vertebra, mm.
inline constexpr double smallest_diagonal_mm = 20, largest_diagonal_mm = 250;

}  // namespace foramen
