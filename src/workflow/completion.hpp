#pragma once
/// \file
/// The input of `foramen complete`, and its results as JSON and as a remark.

#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "foramen/apply/complete_surface.hpp"

namespace foramen {

/// The part of a surface [mm] in the form that complete_surface() takes. Throws InvalidInput as
/// part_surface() does, and if no vertebra has this size.
Mesh usable_part(const TriangleSoup& soup);

/// The result as numbers: distance_mm, matched_share, seen_share, the mean standard deviations of the seen
/// and of the unseen landmarks (0 if there are none), and second_best_pose_mm (null if there is no other
/// pose).
nlohmann::ordered_json completion_json(const CompletedSurface& completed);

/// A remark for the user if another pose fits nearly as well; otherwise unset.
std::optional<std::string> completion_note(const CompletedSurface& completed);

}  // namespace foramen
