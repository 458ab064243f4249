#include "inputs/surface_size.hpp"

#include <array>
#include <sstream>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"

namespace foramen {
namespace {

// The least diagonal of a part that shows where on a vertebra it belongs.
constexpr double smallest_part_mm = 5;
// The sizes of a surface that is probably a whole vertebra, relative to the mean of a model.
constexpr double smallest_whole = 0.5, largest_whole = 1.5;

std::string size_text(double mm) {
  std::ostringstream text;
  text.precision(3);
  text << "the bounding box has a diagonal of " << mm << " mm";
  return text.str();
}

bool is_plausible(double mm) { return mm >= smallest_diagonal_mm && mm <= largest_diagonal_mm; }

// Adds what to do about a size. `likely` is the unit in which the size would be plausible.
Message advised(Message message, double diagonal, LengthUnit unit, std::optional<LengthUnit> likely) {
  if (likely)
    message.append({": the file is probably in " + std::string(name(*likely)) + ", give this unit",
                    {{RemedyKind::give_unit, std::string(name(*likely))}}});
  else if (unit != LengthUnit::millimetre && is_plausible(diagonal))
    message.append({": the file is probably in mm, give no unit", {{RemedyKind::leave_unit_out}}});
  else if (unit == LengthUnit::millimetre)
    message.append({": give its unit, even if that is mm", {{RemedyKind::give_unit}}});
  return message;
}

std::optional<Message> refused_or_noted(const Message& found, double diagonal, const InputUnit& unit,
                                        std::optional<LengthUnit> likely) {
  if (unit.certain) return found;
  throw InvalidInput(advised(found, diagonal, unit.length, likely));
}

// The unit in which this is the diagonal of a whole vertebra rather than of a part.
std::optional<LengthUnit> unit_of_whole(double diagonal, double whole_mm) {
  for (const LengthUnit unit :
       {LengthUnit::millimetre, LengthUnit::centimetre, LengthUnit::metre, LengthUnit::micrometre}) {
    const double mm = diagonal * millimetres_per(unit);
    if (mm >= smallest_whole * whole_mm && mm <= largest_whole * whole_mm) return unit;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Message> check_size(double diagonal, const InputUnit& unit) {
  const double mm = diagonal * millimetres_per(unit.length);
  if (is_plausible(mm)) return std::nullopt;
  return refused_or_noted(size_text(mm) + "; a vertebra has 20 to 250 mm", diagonal, unit,
                          likely_unit(diagonal));
}

std::optional<Message> check_size_of_part(double diagonal, const InputUnit& unit, double whole_mm) {
  const double mm = diagonal * millimetres_per(unit.length);
  if (is_plausible(mm)) return std::nullopt;
  if (mm > largest_diagonal_mm)
    return refused_or_noted(size_text(mm) + ", which is no vertebra's", diagonal, unit,
                            likely_unit(diagonal));
  auto likely = unit_of_whole(diagonal, whole_mm);
  if (likely == unit.length || (!likely && mm >= smallest_part_mm)) return std::nullopt;
  if (!likely) likely = likely_unit(diagonal);
  return refused_or_noted(size_text(mm) + ", very little of a vertebra", diagonal, unit, likely);
}

std::optional<Message> doubt_about_label(double diagonal_mm) {
  if (is_plausible(diagonal_mm)) return std::nullopt;
  return Message(size_text(diagonal_mm) + "; a vertebra has 20 to 250 mm: a part of one, or more than one");
}

void SizeCheck::add(const std::string& source, const std::vector<Vec3>& points) {
  ++shapes_;
  if (points.empty()) return;
  try {
    const auto odd = check_size(bounding_box(points).diagonal() / millimetres_per(unit_.length), unit_);
    if (odd && odd_++ == 0) first_ = odd->about(source).text;
  } catch (const InvalidInput& e) {
    throw InvalidInput(message_of(e).about(source));
  }
}

std::optional<Message> SizeCheck::note() const {
  if (odd_ == 0) return std::nullopt;
  return Message(std::to_string(odd_) + " of " + std::to_string(shapes_) +
                 (odd_ == 1 ? " shapes is" : " shapes are") + " not the size of a vertebra: " + first_);
}

}  // namespace foramen
