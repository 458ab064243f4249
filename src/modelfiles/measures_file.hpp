#pragma once
/// \file
/// Definitions of measures, as text and as a file.

#include <filesystem>
#include <string>

#include "foramen/apply/measure_shape.hpp"

namespace foramen {

/// JSON of this form, all three parts optional:
///
///     {
///       "points":    {"tip": [1.5, 40, -3], "front": 17},
///       "distances": {"length": ["tip", "front"]},
///       "regions":   {"facet": {"centre": "tip", "radius_mm": 6}, "rim": {"landmarks": [3, 4, 5]}}
///     }
///
/// A point is a landmark's index or a position [mm] on mean.ply. Throws InvalidInput naming the part that is
/// not of this form.
MeasureDefinitions parse_measures(const std::string& text);

/// The same from a file. Throws IoError naming file and part.
MeasureDefinitions read_measures(const std::filesystem::path& path);

}  // namespace foramen
