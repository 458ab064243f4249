#include "pages/render_model.hpp"

#include <algorithm>
#include <utility>

#include "findings/model_report.hpp"
#include "foramen/core/error.hpp"
#include "foramen/evaluate/representation.hpp"
#include "foramen/io/mesh_file.hpp"
#include "modelfiles/metrics_file.hpp"
#include "modelfiles/model_record.hpp"
#include "pages/model_pictures.hpp"
#include "pages/page_marks.hpp"
#include "render/render_scene.hpp"
#include "report/pdf_chart.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;

// The corresponding mesh of a shape, in its file's coordinates.
TriangleSoup corresponding(const fs::path& folder, const ModelRecord& record, const std::string& shape) {
  const fs::path file = folder / "corresponding" / (shape + ".ply");
  TriangleSoup soup = read_mesh(file).soup;
  if (soup.triangles != record.loaded.model.triangles())
    throw IoError(file.string() + ": its triangles are not the model's; build the model again");
  return soup;
}

ReportPicture worst_shape(const fs::path& folder, const ModelRecord& record) {
  const auto largest = [](const ErrorMap& map) {
    return *std::max_element(map.landmark_mm.begin(), map.landmark_mm.end());
  };
  const auto worst =
      std::max_element(record.error_maps.begin(), record.error_maps.end(),
                       [&](const ErrorMap& a, const ErrorMap& b) { return largest(a) < largest(b); });
  const std::string& shape = record.evaluation.names[worst - record.error_maps.begin()];
  return shape_distance_picture(shape, corresponding(folder, record, shape), *worst);
}

// The indices of a shape in both models.
using SharedShape = std::pair<std::size_t, std::size_t>;

std::vector<SharedShape> shared_shapes(const ModelRecord& ours, const ModelRecord& baseline) {
  std::vector<SharedShape> shared;
  const auto& names = baseline.evaluation.names;
  for (std::size_t i = 0; i < ours.evaluation.names.size(); ++i) {
    const auto found = std::find(names.begin(), names.end(), ours.evaluation.names[i]);
    if (found != names.end()) shared.emplace_back(i, found - names.begin());
  }
  return shared;
}

// Shows, in both models, the shape on which the baseline has most flipped triangles.
ReportPicture flips(const fs::path& folder, const ModelRecord& ours, const fs::path& baseline_folder,
                    const ModelRecord& baseline, const std::vector<SharedShape>& shared) {
  const auto [i, k] =
      *std::max_element(shared.begin(), shared.end(), [&](const SharedShape& a, const SharedShape& b) {
        return baseline.error_maps[a.second].plain_flips.size() <
               baseline.error_maps[b.second].plain_flips.size();
      });
  const std::string& shape = ours.evaluation.names[i];
  return flips_picture(shape,
                       {corresponding(baseline_folder, baseline, shape), baseline.error_maps[k].plain_flips},
                       {corresponding(folder, ours, shape), ours.error_maps[i].plain_flips});
}

// +1 if the first modes of both models have the same direction, -1 if not, judged by the scores of the
// shapes.
double common_sign(const ModelRecord& ours, const ModelRecord& baseline,
                   const std::vector<SharedShape>& shared) {
  double product = 0;
  for (const auto& [i, k] : shared)
    product += ours.loaded.scores(0, static_cast<Eigen::Index>(i)) *
               baseline.loaded.scores(0, static_cast<Eigen::Index>(k));
  return product < 0 ? -1 : 1;
}

Eigen::Affine3d transform_of(const fs::path& folder, const ModelRecord& record, const std::string& shape) {
  const auto& names = record.atlas.names;
  const auto found = std::find(names.begin(), names.end(), shape);
  if (found == names.end())
    throw IoError((folder / "atlas.h5").string() + ": has no transform of " + shape +
                  "; build the model again");
  return Eigen::Affine3d(record.atlas.transforms[found - names.begin()]);
}

std::vector<ReportPicture> beside_baseline(const fs::path& folder, const ModelRecord& ours,
                                           const fs::path& baseline_folder) {
  const ModelRecord baseline = read_model_record(baseline_folder);
  const auto shared = shared_shapes(ours, baseline);
  if (shared.empty())
    throw InvalidInput(baseline_folder.string() + ": has no shape in common with " + folder.string() +
                       " (by name); build both from the same surfaces");
  // The transform from the baseline's coordinates to ours is that of a shape which both models have.
  const std::string& shape = ours.evaluation.names[shared.front().first];
  const Eigen::Affine3d placement =
      transform_of(folder, ours, shape) * transform_of(baseline_folder, baseline, shape).inverse();
  return {first_mode_beside({&baseline.loaded.model, common_sign(ours, baseline, shared), placement},
                            {&ours.loaded.model}),
          flips(folder, ours, baseline_folder, baseline, shared)};
}

std::vector<ReportPicture> pictures(const fs::path& folder, const fs::path& baseline) {
  const ModelRecord record = read_model_record(folder);
  const ShapeModel& model = record.loaded.model;
  std::vector<ReportPicture> out = model_pictures(record.atlas, model);
  out.push_back(overview_picture(record.atlas, model));
  if (model.modes() > 0) out.push_back(modes_plate(model));
  out.push_back(mean_distance_picture(model, record.error_maps));
  out.push_back(worst_shape(folder, record));
  if (const std::vector<PageMark> marks = page_marks(record); !marks.empty())
    out.push_back(marks_picture(model, marks));
  if (!baseline.empty())
    for (ReportPicture& picture : beside_baseline(folder, record, baseline))
      out.push_back(std::move(picture));
  return out;
}

std::vector<Chart> curves(const fs::path& folder, const fs::path& baseline) {
  const Evaluation ours = read_metrics_of_shapes(folder);
  if (baseline.empty()) return model_charts({{"this model", &ours}});
  const Evaluation theirs = read_metrics_of_shapes(baseline);
  return model_charts({{"this model", &ours}, {"baseline: " + folder_name(baseline), &theirs}});
}

}  // namespace

std::vector<RenderedFile> render_model(const fs::path& folder, const RenderOptions& options) {
  if (!options.only_curves && !can_render())
    throw Error(
        "pictures need VTK in the build and a display: install libvtk9-dev, build again, and run under "
        "xvfb-run -a; curves alone need neither",
        {{RemedyKind::only_curves}});
  std::vector<RenderedFile> files;
  if (!options.only_curves)
    for (ReportPicture& picture : pictures(folder, options.baseline))
      files.push_back({picture.file_stem + ".png", std::move(picture.png), std::move(picture.caption)});
  for (const Chart& chart : curves(folder, options.baseline)) {
    const std::string caption = chart.title + ", over the number of modes; bars are standard errors";
    files.push_back({chart.file_stem + ".svg", svg_chart_file(chart), caption});
    files.push_back({chart.file_stem + ".pdf", pdf_chart(chart), caption});
  }
  return files;
}

}  // namespace foramen
