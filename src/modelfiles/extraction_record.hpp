#pragma once
/// \file
/// How a label of a label map became a surface, as files hold it.

#include <string_view>
#include <utility>

#include <nlohmann/json_fwd.hpp>

#include "extract/extract_labels.hpp"
#include "foramen/core/options.hpp"

namespace foramen {

template <>
struct EnumWords<EdgeContact> {
  static constexpr std::pair<std::string_view, EdgeContact> all[] = {{"joined", EdgeContact::joined},
                                                                     {"apart", EdgeContact::apart}};
};

/// How far the surface is from the voxels; the mean is not written.
template <class Fields>
void list_fields(Fields& fields, MaybeConst<SurfaceDistance> auto& deviation) {
  fields("p95", deviation.p95);
  fields("largest", deviation.hausdorff);
}

template <class Fields>
void list_fields(Fields& fields, MaybeConst<ExtractionReport> auto& r) {
  fields("genus", r.genus);
  fields("edge_contacts", r.contact);
  fields("components", r.components);
  fields("voxels", r.voxels);
  fields("voxels_left_out", r.lost_voxels);
  fields("voxels_filled", r.filled_voxels);
  fields("cut_at", r.cut_at);
  fields("voxel_volume_mm3", r.voxel_volume);
  fields("volume_mm3", r.volume);
  fields("deviation_voxels", r.deviation);
  fields("deviation_mm", r.deviation_mm);
  fields("bound_voxels", r.bound);
  fields("vertices_restrained", r.restrained);
}

nlohmann::ordered_json extraction_json(const ExtractionReport& report);
/// Options for label maps by their command-line names.
nlohmann::ordered_json label_options_json(const LabelRequest& request);

}  // namespace foramen
