#pragma once
/// \file
/// Pictures of a model, for reports and papers. All functions throw Error if no picture can be made (see
/// can_render()), unless their comment says otherwise.

#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "evaluate/error_map.hpp"
#include "foramen/evaluate/representation.hpp"
#include "foramen/model/shape_model.hpp"
#include "modelfiles/atlas.hpp"
#include "pages/page_marks.hpp"
#include "report/report_page.hpp"

namespace foramen {

/// The template with its loops, its torus map beside the surface in the same colours, and the first modes at
/// +-2 sd. The list is empty if no picture can be made.
std::vector<ReportPicture> model_pictures(const Atlas& atlas, const ShapeModel& model);

/// The steps from the template to the model in one row: loops, torus map, the map on the surface, and the
/// mean with its landmark triangles. This is the paper's Fig. 1.
ReportPicture overview_picture(const Atlas& atlas, const ShapeModel& model);

/// The first modes, with one row each: -2 and +2 sd in two views, and the distance by which each point moves
/// at 1 sd.
/// \pre the model has a mode
ReportPicture modes_plate(const ShapeModel& model);

/// A model that is shown beside another one.
struct PicturedModel {
  const ShapeModel* model = nullptr;
  /// +1 or -1. The sign of a mode is arbitrary; this factor gives the first mode the direction of the other
  /// model's.
  double first_mode_sign = 1;
  Eigen::Affine3d placement = Eigen::Affine3d::Identity();  ///< from model to picture coordinates
};
/// The first mode at +2 sd (above) and -2 sd of the baseline (left) and of this model (right), seen by the
/// same camera. Each triangle is shaded flat, so that folds are visible. This is the paper's Fig. 3. \pre
/// both have a mode
ReportPicture first_mode_beside(const PicturedModel& baseline, const PicturedModel& ours);

/// The distances between the corresponding meshes and their inputs: the root mean square over the shapes, as
/// colours on the mean. \pre at least one map, all fit the model
ReportPicture mean_distance_picture(const ShapeModel& model, const std::vector<ErrorMap>& maps);

/// The distances of one shape to its input, as colours on its corresponding mesh.
ReportPicture shape_distance_picture(const std::string& shape, const TriangleSoup& corresponding,
                                     const ErrorMap& map);

/// The marks of all shapes on the mean, from three sides, with a key of their colours and scatter.
/// \pre at least one mark
ReportPicture marks_picture(const ShapeModel& model, const std::vector<PageMark>& marks);

/// A corresponding mesh and its flipped triangles.
struct FlippedMesh {
  TriangleSoup soup;
  std::vector<int> flipped;
};

/// One shape in two models with flipped triangles in red, seen by the same cameras: the whole shape, and a
/// close-up of the place where most of the baseline's flips are visible. This is the paper's Fig. 2.
ReportPicture flips_picture(const std::string& shape, const FlippedMesh& baseline, const FlippedMesh& ours);

}  // namespace foramen
