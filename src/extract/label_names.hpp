#pragma once
/// \file
/// What the numbers of a label map stand for.

#include <filesystem>
#include <map>
#include <string>

namespace foramen {

/// Names by label.
using LabelNames = std::map<int, std::string>;

enum class LabelNumbering {
  verse,             ///< 1-7 C1-C7, 8-19 T1-T12, 20-25 L1-L6, 26 sacrum, 27 coccyx, 28 T13
  totalsegmentator,  ///< version 2, task total: 25 sacrum, 26 S1, 27-31 L5-L1, 32-43 T12-T1, 44-50 C7-C1
};

const LabelNames& label_names(LabelNumbering numbering);

/// Reads a CSV file with the columns label and name, e.g. "20,L1". Names become parts of file names: letters,
/// digits and - _ . are allowed. Throws IoError naming file and row: a label that is no whole number 1 ..
/// 65535, a name of other characters, a label or a name twice.
LabelNames read_label_names(const std::filesystem::path& path);

/// The label's name; "label37" where there is none.
std::string name_of(const LabelNames& names, int label);

}  // namespace foramen
