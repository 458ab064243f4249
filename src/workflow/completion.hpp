#pragma once
/// \file
/// What `foramen complete` does about a completion: the part as it comes, and what is said of the result.

#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "foramen/apply/complete_surface.hpp"

namespace foramen {

/// A part of a surface [mm] as complete_surface() takes it. Throws InvalidInput as part_surface() does, and
/// for a size that is no vertebra's.
Mesh usable_part(const TriangleSoup& soup);

/// In numbers: distance_mm, matched_share, seen_share, the means of the landmarks' standard deviations where
/// seen and where not (0: there are none), second_best_pose_mm (null: there is no other pose).
nlohmann::ordered_json completion_json(const CompletedSurface& completed);

/// What the user should know though it is no error: that another pose fits nearly as well.
std::optional<std::string> completion_note(const CompletedSurface& completed);

}  // namespace foramen
