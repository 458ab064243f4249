#pragma once
/// \file
/// Private to io: what a header calls the labels of a label map.

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "io/file_bytes.hpp"

namespace foramen::io_detail {

/// The segments of 3D Slicer in the pairs key:=value of an NRRD header: SegmentN_Name, SegmentN_LabelValue
/// and SegmentN_Layer.
class SegmentNames {
 public:
  /// Takes the pair if it is one of a segment; other pairs are passed over.
  void add(std::string_view key, std::string_view value);
  bool empty() const { return segments_.empty(); }
  /// The names by layer and label. Segments without a name or a label, and of other layers, have no entry.
  std::vector<std::map<int, std::string>> by_layer(std::int64_t layers) const;

 private:
  struct Segment {
    std::string name;
    std::int64_t label = 0, layer = 0;
  };
  std::map<std::int64_t, Segment> segments_;
};

/// The names in the first table of labels (LabelTable) among the header extensions of a NIfTI file, whose
/// bytes begin after the four bytes that announce them. Empty if there is no such table or it is damaged:
/// names are a help, and the voxels do not depend on them.
std::map<int, std::string> names_in_extensions(const Source& source, std::string_view extensions,
                                               ByteOrder order);

}  // namespace foramen::io_detail
