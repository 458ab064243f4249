#pragma once
/// \file
/// Pictures of a model, for reports and papers.

#include <string>
#include <vector>

#include "foramen/model/shape_model.hpp"
#include "foramen/pipeline/atlas_file.hpp"
#include "foramen/report/report_page.hpp"

namespace foramen {

/// The template with its loops, its torus map beside the surface in the same colours, and the first modes at
/// +-2 sd; empty where no picture can be made (see can_render()).
std::vector<ReportPicture> model_pictures(const Atlas& atlas, const ShapeModel& model);

/// A corresponding mesh and its flipped triangles.
struct FlippedMesh {
  TriangleSoup soup;
  std::vector<int> flipped;
};

/// One shape in two models, flipped triangles red, seen by the same cameras: the whole, and closer where
/// most of the baseline's flips are seen. The paper's Fig. 2. Throws Error where no picture can be made.
ReportPicture flips_picture(const std::string& shape, const FlippedMesh& baseline, const FlippedMesh& ours);

}  // namespace foramen
