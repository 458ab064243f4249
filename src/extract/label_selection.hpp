#pragma once
/// \file
/// Which labels of a label map are wanted.

#include <string>
#include <string_view>
#include <vector>

namespace foramen {

/// Labels as one writes them: "20-24,3".
class LabelSelection {
 public:
  struct Range {
    int first = 1, last = 1;  ///< 1 .. 65535, first <= last
  };
  /// Whole numbers and ranges, separated by commas. Throws InvalidInput naming the part that is neither.
  static LabelSelection parse(std::string_view text);
  const std::vector<Range>& ranges() const { return ranges_; }
  bool contains(int label) const;
  /// Whether the label was named by itself, so that its absence is a mistake.
  bool named_singly(int label) const;
  /// "20-24,3": as it was written.
  std::string text() const;

 private:
  std::vector<Range> ranges_;
};

/// "3, 20-24" for sorted labels: runs of at least three as ranges.
std::string listed(const std::vector<int>& labels);

}  // namespace foramen
