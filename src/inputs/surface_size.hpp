#pragma once
/// \file
/// The check of sizes that every command makes which takes surfaces: whether their lengths are in mm.

#include <optional>
#include <string>
#include <vector>

#include "foramen/core/mesh.hpp"
#include "foramen/core/remedy.hpp"
#include "foramen/core/units.hpp"

namespace foramen {

/// Checks that a vertebra can have this size, which is a bounding-box diagonal of 20 to 250 mm.
/// Returns nothing if it can. Otherwise throws InvalidInput with the unit that is likely, or returns the
/// message as a note if the unit is certain.
/// \param diagonal  of the bounding box, in the unit
std::optional<Message> check_size(double diagonal, const InputUnit& unit);

/// As check_size(), for a part of a vertebra, which may be smaller. A part of less than 20 mm is refused if
/// in another unit it would have half to one and a half times the size of the whole, or if it has less than 5
/// mm.
/// \param whole_mm  diagonal of the whole vertebra of which it is a part, such as the mean of a model
std::optional<Message> check_size_of_part(double diagonal, const InputUnit& unit, double whole_mm);

/// As check_size(), for a surface of a label map, whose unit is known: nothing if a vertebra can have this
/// size, and otherwise what the surface may be instead.
std::optional<Message> doubt_about_label(double diagonal_mm);

/// As check_size() for several shapes. The error names the first shape that is no vertebra's size; the note
/// says how many there are.
class SizeCheck {
 public:
  explicit SizeCheck(const InputUnit& unit) : unit_(unit) {}
  /// \param source  what the message names, e.g. the file
  void add(const std::string& source, const std::vector<Vec3>& points);
  /// Set if the unit is certain and a shape is no vertebra's size.
  std::optional<Message> note() const;

 private:
  InputUnit unit_;
  int shapes_ = 0, odd_ = 0;
  std::string first_;
};

}  // namespace foramen
