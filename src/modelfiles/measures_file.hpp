#pragma once
/// \file
/// Definitions of measures, as text and as a file.

#include <filesystem>
#include <string>

#include "foramen/apply/measure_shape.hpp"

namespace foramen {

/// Parses JSON of this form, in which each of the three parts is optional:
///
///     {
///       "points":    {"tip": [1.5, 40, -3], "front": 17},
///       "distances": {"length": ["tip", "front"]},
///       "regions":   {"facet": {"centre": "tip", "radius_mm": 6}, "rim": {"landmarks": [3, 4, 5]}}
///     }
///
/// A point is a landmark's index or a position [mm] on mean.ply. Throws InvalidInput, which names the part
/// that does not have this form.
MeasureDefinitions parse_measures(const std::string& text);

/// As parse_measures(), for a file. Throws IoError, which names the file and the part.
MeasureDefinitions read_measures(const std::filesystem::path& path);

}  // namespace foramen
