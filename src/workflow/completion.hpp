#pragma once
/// \file
/// The input of `foramen complete`, and its results as JSON and as a remark.

#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "foramen/apply/complete_surface.hpp"
#include "foramen/core/remedy.hpp"
#include "foramen/core/units.hpp"
#include "foramen/model/shape_model.hpp"

namespace foramen {

/// A part of a vertebra's surface in the form that complete_surface() takes.
struct PartOfVertebra {
  Mesh mesh;                                        ///< mm
  std::optional<Message> size_note = std::nullopt;  ///< see check_size_of_part()
};

/// The part in mm. Throws InvalidInput as part_surface() and check_size_of_part() do.
/// \param unit  of the soup
/// \param model  of the whole vertebra
PartOfVertebra usable_part(TriangleSoup soup, const InputUnit& unit, const ShapeModel& model);

/// The result as numbers: distance_mm, matched_share, seen_share, the mean standard deviations of the seen
/// and of the unseen landmarks (0 if there are none), and second_best_pose_mm (null if there is no other
/// pose).
nlohmann::ordered_json completion_json(const CompletedSurface& completed);

/// A remark for the user if another pose fits nearly as well; otherwise unset.
std::optional<std::string> completion_note(const CompletedSurface& completed);

}  // namespace foramen
