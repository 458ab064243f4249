#pragma once
/// \file
/// A selection of labels of a label map.

#include <string>
#include <string_view>
#include <vector>

namespace foramen {

/// Labels and ranges of labels, written as "20-24,3".
class LabelSelection {
 public:
  struct Range {
    int first = 1, last = 1;  ///< 1 .. 65535, first <= last
  };
  /// Parses whole numbers and ranges separated by commas. Throws InvalidInput with the part that is neither.
  static LabelSelection parse(std::string_view text);
  const std::vector<Range>& ranges() const { return ranges_; }
  bool contains(int label) const;
  /// Whether the label was named by itself and not by a range, so that its absence is an error.
  bool named_singly(int label) const;
  /// The selection as it was written, e.g. "20-24,3".
  std::string text() const;

 private:
  std::vector<Range> ranges_;
};

/// Sorted labels as text, e.g. "3, 20-24". Runs of at least three labels become ranges.
std::string listed(const std::vector<int>& labels);

}  // namespace foramen
