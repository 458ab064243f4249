#include "extract/label_names.hpp"

#include <algorithm>
#include <charconv>
#include <set>

#include "foramen/core/error.hpp"
#include "io/table_file.hpp"

namespace foramen {
namespace {

// Adds the names Prefix1, Prefix2 ... for the labels first, first + step ...; step is 1 or -1.
void add_series(LabelNames& names, const std::string& prefix, int count, int first, int step) {
  for (int i = 0; i < count; ++i) names[first + step * i] = prefix + std::to_string(i + 1);
}

LabelNames verse_names() {
  LabelNames names{{26, "sacrum"}, {27, "coccyx"}, {28, "T13"}};
  add_series(names, "C", 7, 1, 1);
  add_series(names, "T", 12, 8, 1);
  add_series(names, "L", 6, 20, 1);
  return names;
}

LabelNames totalsegmentator_names() {
  LabelNames names{{25, "sacrum"}, {26, "S1"}};
  add_series(names, "L", 5, 31, -1);
  add_series(names, "T", 12, 43, -1);
  add_series(names, "C", 7, 50, -1);
  return names;
}

LabelNames totalsegmentator_v1_names() {
  LabelNames names{{92, "sacrum"}};
  add_series(names, "L", 5, 22, -1);
  add_series(names, "T", 12, 34, -1);
  add_series(names, "C", 7, 41, -1);
  return names;
}

LabelNames totalspineseg_names() {
  LabelNames names{{50, "sacrum"}};
  add_series(names, "C", 7, 11, 1);
  add_series(names, "T", 12, 21, 1);
  add_series(names, "L", 5, 41, 1);
  return names;
}

bool allowed(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '_' ||
         c == '.';
}

}  // namespace

const LabelNames& label_names(LabelNumbering numbering) {
  static const LabelNames verse = verse_names(), totalsegmentator = totalsegmentator_names(),
                          totalsegmentator_v1 = totalsegmentator_v1_names(),
                          totalspineseg = totalspineseg_names();
  switch (numbering) {
    case LabelNumbering::totalsegmentator:
      return totalsegmentator;
    case LabelNumbering::totalsegmentator_v1:
      return totalsegmentator_v1;
    case LabelNumbering::totalspineseg:
      return totalspineseg;
    default:
      return verse;
  }
}

LabelNames read_label_names(const std::filesystem::path& path) {
  const Table table = read_csv(path);
  const std::size_t label_column = table.column("label"), name_column = table.column("name");
  LabelNames names;
  std::set<std::string> taken;
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    const std::string &written = table.rows[r][label_column], &name = table.rows[r][name_column];
    const auto refuse = [&](const std::string& found) {
      throw IoError(path.string() + ": row " + std::to_string(r + 1) + ": " + found);
    };
    constexpr int largest = 65535;
    int label = 0;
    const auto [end, failed] = std::from_chars(written.data(), written.data() + written.size(), label);
    if (failed != std::errc() || end != written.data() + written.size() || label < 1 || label > largest)
      refuse("'" + written + "' is no label; labels are whole numbers from 1 to 65535");
    if (name.empty() || !std::all_of(name.begin(), name.end(), allowed))
      refuse("'" + name + "' cannot be a part of a file name; use letters, digits, - _ and .");
    if (!names.emplace(label, name).second) refuse("label " + written + " is there twice; remove one");
    if (!taken.insert(name).second) refuse("the name '" + name + "' is there twice; rename one");
  }
  return names;
}

std::string name_for_files(std::string_view name) {
  std::string text(name);
  for (char& c : text)
    if (!allowed(c)) c = '_';
  return text;
}

std::string name_of(const LabelNames& names, int label) {
  const auto found = names.find(label);
  return found == names.end() ? "label" + std::to_string(label) : found->second;
}

}  // namespace foramen
