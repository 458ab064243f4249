#pragma once
/// \file
/// The names of the labels of a label map.

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "foramen/core/options.hpp"

namespace foramen {

/// Maps labels to names.
using LabelNames = std::map<int, std::string>;

enum class LabelNumbering {
  verse,                ///< 1-7 C1-C7, 8-19 T1-T12, 20-25 L1-L6, 26 sacrum, 27 coccyx, 28 T13
  totalsegmentator,     ///< version 2, task total: 25 sacrum, 26 S1, 27-31 L5-L1, 32-43 T12-T1, 44-50 C7-C1
  totalsegmentator_v1,  ///< version 1: 18-22 L5-L1, 23-34 T12-T1, 35-41 C7-C1, 92 sacrum
  totalspineseg,        ///< 11-17 C1-C7, 21-32 T1-T12, 41-45 L1-L5, 50 sacrum
};
template <>
struct EnumWords<LabelNumbering> {
  static constexpr std::pair<std::string_view, LabelNumbering> all[] = {
      {"verse", LabelNumbering::verse},
      {"totalsegmentator", LabelNumbering::totalsegmentator},
      {"totalsegmentator-v1", LabelNumbering::totalsegmentator_v1},
      {"totalspineseg", LabelNumbering::totalspineseg}};
};

const LabelNames& label_names(LabelNumbering numbering);

/// Reads a CSV file with the columns label and name, e.g. "20,L1". Names become parts of file names, so only
/// letters, digits and - _ . are allowed. Throws IoError with the file and the row: a label that is not a
/// whole number 1 .. 65535, a name with other characters, or a label or name that occurs twice.
LabelNames read_label_names(const std::filesystem::path& path);

/// The name with _ in place of each character that cannot be a part of a file name, see read_label_names().
std::string name_for_files(std::string_view name);

/// The name of a label, or e.g. "label37" if it has none.
std::string name_of(const LabelNames& names, int label);

}  // namespace foramen
