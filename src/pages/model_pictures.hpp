#pragma once
/// \file
/// Pictures of a model, for reports and papers. All throw Error where no picture can be made (see
/// can_render()), unless they say otherwise.

#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "evaluate/error_map.hpp"
#include "foramen/evaluate/representation.hpp"
#include "foramen/model/shape_model.hpp"
#include "modelfiles/atlas_file.hpp"
#include "report/report_page.hpp"

namespace foramen {

/// The template with its loops, its torus map beside the surface in the same colours, and the first modes at
/// +-2 sd; empty where no picture can be made.
std::vector<ReportPicture> model_pictures(const Atlas& atlas, const ShapeModel& model);

/// From the template to the model in one strip: loops, torus map, the map on the surface, the mean with its
/// landmark triangles. The paper's Fig. 1.
ReportPicture overview_picture(const Atlas& atlas, const ShapeModel& model);

/// The first modes, a row each: -2 and +2 sd in two views, and how far each point moves at 1 sd.
/// \pre the model has a mode
ReportPicture modes_plate(const ShapeModel& model);

/// A model to be seen beside another.
struct PicturedModel {
  const ShapeModel* model = nullptr;
  /// +1 or -1: the sign of a mode means nothing, and this turns the first as the other model's.
  double first_mode_sign = 1;
  Eigen::Affine3d placement = Eigen::Affine3d::Identity();  ///< of the model in the picture
};
/// The first mode at +2 sd (above) and -2 sd of the baseline (left) and of this model, seen by one camera,
/// each triangle flat, so that folds show. The paper's Fig. 3. \pre both have a mode
ReportPicture first_mode_beside(const PicturedModel& baseline, const PicturedModel& ours);

/// How far the corresponding meshes are from their inputs: root mean square over the shapes, in colours on
/// the mean. \pre at least one map, all fit the model
ReportPicture mean_distance_picture(const ShapeModel& model, const std::vector<ErrorMap>& maps);

/// The same of one shape, on its corresponding mesh.
ReportPicture shape_distance_picture(const std::string& shape, const TriangleSoup& corresponding,
                                     const ErrorMap& map);

/// A corresponding mesh and its flipped triangles.
struct FlippedMesh {
  TriangleSoup soup;
  std::vector<int> flipped;
};

/// One shape in two models, flipped triangles red, seen by the same cameras: the whole, and closer where
/// most of the baseline's flips are seen. The paper's Fig. 2.
ReportPicture flips_picture(const std::string& shape, const FlippedMesh& baseline, const FlippedMesh& ours);

}  // namespace foramen
