#pragma once
/// \file
/// How well the labels of a label map fit a numbering.

#include <map>
#include <string>
#include <vector>

#include "extract/label_names.hpp"
#include "foramen/extract/extract_label.hpp"

namespace foramen {

/// The labels of a map and how high they lie.
using LabelHeights = std::map<int, double>;  ///< LPS z of the middle of the label's extent [mm]
LabelHeights heights_of(const LabelMap& map, const std::map<int, LabelExtent>& present);

/// The numberings, other than this one, that fit the labels better. A numbering fits better if it names
/// more labels, where a level that lies above its upper neighbour counts against it twice; if this is
/// equal, the better one leaves no gap between the levels where the other one leaves one. Empty if none
/// fits better.
std::vector<LabelNumbering> better_numberings(const LabelHeights& labels, LabelNumbering than);

/// The numberings, other than this one, that put all labels they name, and at least one, into that part of
/// the spine (C, T, L or S).
std::vector<LabelNumbering> numberings_in_region(const LabelHeights& labels, char region,
                                                 LabelNumbering than);

/// What the numbering calls the labels: "21 is T1, 22 is T2"; at most five of them. Empty if it names none.
std::string meaning_of(const LabelHeights& labels, LabelNumbering numbering);

/// Whether the numbering puts any of the labels into that part of the spine.
bool any_in_region(const LabelHeights& labels, char region, LabelNumbering numbering);

}  // namespace foramen
