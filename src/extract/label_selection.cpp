#include "extract/label_selection.hpp"

#include <algorithm>
#include <charconv>

#include "foramen/core/error.hpp"

namespace foramen {
namespace {

constexpr int largest_label = 65535;

int parse_label(std::string_view number, std::string_view part) {
  int label = 0;
  const auto [end, failed] = std::from_chars(number.data(), number.data() + number.size(), label);
  if (failed != std::errc() || end != number.data() + number.size() || label < 1 || label > largest_label)
    throw InvalidInput("'" + std::string(part) +
                       "' is no label or range of labels; write whole numbers from 1 to 65535, e.g. 20-24,3");
  return label;
}

std::string text_of(int first, int last) {
  std::string text = std::to_string(first);
  if (last != first) text.append("-").append(std::to_string(last));
  return text;
}

}  // namespace

LabelSelection LabelSelection::parse(std::string_view text) {
  LabelSelection selection;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string_view part = text.substr(begin, end - begin);
    const std::size_t dash = std::min(part.find('-'), part.size());
    const int first = parse_label(part.substr(0, dash), part);
    const int last = dash == part.size() ? first : parse_label(part.substr(dash + 1), part);
    if (last < first)
      throw InvalidInput("'" + std::string(part) + "' runs backwards; write " + text_of(last, first));
    selection.ranges_.push_back({first, last});
    begin = end + 1;
  }
  return selection;
}

bool LabelSelection::contains(int label) const {
  return std::any_of(ranges_.begin(), ranges_.end(),
                     [&](const Range& r) { return r.first <= label && label <= r.last; });
}

bool LabelSelection::named_singly(int label) const {
  return std::any_of(ranges_.begin(), ranges_.end(),
                     [&](const Range& r) { return r.first == label && r.last == label; });
}

std::string LabelSelection::text() const {
  std::string all;
  for (const Range& r : ranges_) {
    if (!all.empty()) all += ",";
    all += text_of(r.first, r.last);
  }
  return all;
}

std::string listed(const std::vector<int>& labels) {
  std::string all;
  for (std::size_t begin = 0; begin < labels.size();) {
    std::size_t end = begin + 1;
    while (end < labels.size() && labels[end] == labels[end - 1] + 1) ++end;
    if (end - begin < 3) end = begin + 1;
    if (!all.empty()) all += ", ";
    all += text_of(labels[begin], labels[end - 1]);
    begin = end;
  }
  return all;
}

}  // namespace foramen
