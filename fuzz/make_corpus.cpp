// make_corpus FOLDER writes the inputs with which the fuzzers begin: small files of every kind, valid and
// broken.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>

#include "cli/bad_input/bad_shapes.hpp"
#include "foramen/evaluate/evaluate.hpp"
#include "foramen/evaluate/mark_transfer.hpp"
#include "foramen/io/mesh_file.hpp"
#include "foramen/io/statismo_file.hpp"
#include "io/atomic_file.hpp"
#include "io/malformed_meshes.hpp"
#include "io/mesh_bytes.hpp"
#include "io/named_points.hpp"
#include "io/scalismo_landmarks.hpp"
#include "io/shapeworks_project.hpp"
#include "io/zip_bytes.hpp"
#include "modelfiles/atlas_file.hpp"
#include "modelfiles/metrics_file.hpp"
#include "soup_bytes.hpp"
#include "support/handles.hpp"
#include "support/label_maps.hpp"
#include "support/meshes.hpp"
#include "support/torus_cohort.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;

std::string number(double x) { return std::to_string(x) + " "; }

std::string point_lines(const TriangleSoup& soup, const std::string& before) {
  std::string text;
  for (const Vec3& p : soup.points) text += before + number(p.x()) + number(p.y()) + number(p.z()) + "\n";
  return text;
}

std::string triangle_lines(const TriangleSoup& soup, const std::string& before, int first) {
  std::string text;
  for (const auto& t : soup.triangles) {
    text += before;
    for (int corner : t) text += std::to_string(corner + first) + " ";
    text += "\n";
  }
  return text;
}

void write_meshes(const fs::path& folder) {
  const TriangleSoup torus = testing::torus_soup(5, 4), tetrahedron = testing::tetrahedron();
  for (const auto& [name, soup] :
       {std::pair<std::string, TriangleSoup>("torus", torus), {"tetrahedron", tetrahedron}}) {
    const std::string v = std::to_string(soup.points.size()), f = std::to_string(soup.triangles.size());
    const std::string points = point_lines(soup, ""), faces = triangle_lines(soup, "3 ", 0);
    write_ply(folder / (name + ".ply"), soup);
    write_vtp(folder / (name + ".vtp"), soup);
    write_file(folder / (name + "_text.ply"), testing::malformed::ply(v, f, points + faces));
    write_file(folder / (name + ".stl"), testing::binary_stl(soup));
    write_file(folder / (name + "_text.stl"), testing::ascii_stl(soup));
    write_file(folder / (name + ".obj"), point_lines(soup, "v ") + triangle_lines(soup, "f ", 1));
    write_file(folder / (name + ".off"), "OFF\n" + v + " " + f + " 0\n" + points + faces);
    write_file(folder / (name + ".vtk"),
               "# vtk DataFile Version 3.0\nSPACE=RAS\nASCII\nDATASET POLYDATA\nPOINTS " + v + " float\n" +
                   points + "POLYGONS " + f + " " + std::to_string(4 * soup.triangles.size()) + "\n" + faces);
  }
  write_file(folder / "quads.off", "COFF\n4 2 0\n0 0 0 1 1 1\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n2 0 1\n");
  write_file(folder / "continued.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 \\\n3 4\nl 1 2\n");
  write_file(folder / "strips.ply",
             "ply\ncomment x\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
             "property float z\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n"
             "0 0 0\n1 0 0\n0 1 0\n1 1 0\n6 0 1 2 -1 1 2\n");
  write_file(folder / "fields.vtk",
             "# vtk DataFile Version 5.1\nx\nASCII\nDATASET POLYDATA\nFIELD f 2\ns 1 1 string\nab\nb 1 2 "
             "bit\n1 0\nPOINTS 4 float\n0 0 0 1 0 0 0 1 0 1 1 0\nVERTICES 2 1\nOFFSETS vtktypeint64\n0 1\n"
             "CONNECTIVITY vtktypeint64\n0\nTRIANGLE_STRIPS 2 4\nOFFSETS vtktypeint64\n0 4\nCONNECTIVITY "
             "vtktypeint64\n0 1 2 3\n");
  write_file(
      folder / "grid.vtk",
      "# vtk DataFile Version 2.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n0 0 0 1 0 0 0 1 "
      "0 1 1 0\nCELLS 4 17\n3 0 1 2\n4 0 1 2 3\n4 0 1 2 3\n2 0 3\nCELL_TYPES 4\n5\n8\n6\n3\n");
  for (const auto& file : testing::malformed::all_files())
    write_file(folder / (file.name + "." + file.extension), file.bytes);
}

Atlas small_atlas() {
  constexpr int around = 5, tube = 4;
  Atlas atlas;
  atlas.surface = build_mesh(testing::torus_soup(around, tube));
  atlas.map.turns = VertexMap<Vec2>(atlas.surface.vertex_count(), Vec2(0.25, 0.5));
  atlas.map.jumps = HalfedgeMap<Vec2i>(atlas.surface.halfedge_count(), Vec2i(1, -2));
  for (int i = 0; i < around; ++i) atlas.loops[0].emplace_back(i * tube);
  for (int j = 0; j < tube; ++j) atlas.loops[1].emplace_back(j);
  atlas.landmarks.turns = {Vec2(0.1, 0.2), Vec2(0.3, 0.4), Vec2(0.5, 0.6)};
  atlas.landmarks.triangles = {{0, 1, 2}};
  atlas.landmarks.jumps = HalfedgeMap<Vec2i>(3, Vec2i::Zero());
  atlas.names = {"a"};
  atlas.transforms = {Eigen::Matrix4d::Identity()};
  return atlas;
}

void write_models(const fs::path& folder) {
  StatismoModel model;
  const TriangleSoup soup = testing::tetrahedron();
  model.points = soup.points;
  model.triangles = soup.triangles;
  model.mean = flattened(soup.points);
  model.basis = Eigen::MatrixXd::Identity(model.mean.size(), 2);
  model.variance = Eigen::Vector2d(2, 1);
  model.scores = Eigen::MatrixXd::Constant(2, 3, 0.5);
  model.shape_uris = {"a.ply", "b.ply", "c.ply"};
  model.parameters = {{"command", "foramen build"}};
  write_statismo(folder / "model.h5", model);
  model.landmark_weights = {1, 2, 3, 4};
  write_statismo(folder / "weighted.h5", model);
  write_atlas(folder / "atlas.h5", small_atlas());
  const CorrespondingCohort cohort = testing::torus_cohort({.shapes = 3});
  EvaluationOptions options;
  options.draws = 2;
  options.samples = options.specificity_samples = 20;
  Evaluation evaluation = evaluate(cohort, options, RunContext(1));
  std::vector<MarksOfShape> marks;
  for (const std::vector<Vec3>& points : cohort.corresponding)
    marks.push_back({{"tip", MarkKind::point, {points[0]}},
                     {"rim", MarkKind::closed_curve, {points[1], points[2], points[9]}}});
  evaluation.marks = mark_transfer(cohort, marks, RunContext(1));
  write_file(folder / "metrics.json", metrics_json(evaluation));
}

void write_exchange_files(const fs::path& folder) {
  StatismoModel model;
  const TriangleSoup soup = testing::tetrahedron();
  model.points = soup.points;
  model.triangles = soup.triangles;
  model.mean = flattened(soup.points);
  model.basis = Eigen::MatrixXd::Identity(model.mean.size(), 1);
  model.variance = Eigen::VectorXd::Ones(1);
  write_statismo(folder / "model.h5.json", model);
  const std::vector<NamedPoints> shapes{{"a", soup.points}, {"b", soup.points}};
  write_tps(folder / "shapes.tps", shapes);
  write_landmark_table(folder / "shapes.csv", shapes);
  write_particles(folder / "a.particles", soup.points);
  write_scalismo_landmarks(folder / "landmarks.json", std::vector<ScalismoLandmark>{{"0", {1, 2, 3}, "tip"}});
  ShapeWorksSubject subject;
  subject.name = "a";
  subject.local_particles = "a.particles";
  write_shapeworks(folder / "a.swproj", std::vector{subject}, soup.points.size());
  const std::string rows =
      "<row><c t=\"s\"><v>0</v></c><c t=\"inlineStr\"><is><t>shape_1</t></is></c></row>"
      "<row><c r=\"A2\"><v>7</v></c><c r=\"B2\" t=\"str\"><v>a.ply</v></c></row>";
  for (const bool deflate : {true, false})
    write_file(folder / (deflate ? "deflated.xlsx" : "stored.xlsx"),
               testing::zip_bytes(testing::spreadsheet(rows, "<si><t>name</t></si>"), deflate));
  write_file(folder / "missing.tps", "LM=1\n1 2 3\nLM3=1\nNA 2 3\nCURVES=1\nPOINTS=1\n1 2\n");
}

void write_soups(const fs::path& folder) {
  const auto write = [&](const std::string& name, const TriangleSoup& soup) {
    if (soup.points.size() < 256) write_file(folder / name, fuzzing::soup_bytes(soup));
  };
  for (const auto& [name, surface] : testing::unusable_surfaces()) write(name, surface.first);
  write("torus", testing::torus_soup(8, 6));
  write("plate", testing::plate(1));
  testing::TorusWithHandles handles(14, 8);
  handles.drill(2, 1);
  handles.bridge(6, 8, 1, 4);
  write("handles", handles.soup);
}

void write_label_maps(const fs::path& folder) {
  const auto torus_at = [](const Vec3& p) { return testing::bumpy_torus(p) < 0 ? 20 : p.z() > 6 ? 3 : 0; };
  const LabelMap torus = testing::labelled_lattice({9, 9, 5}, 5 * Mat3::Identity(), torus_at);
  int next = 0;
  const LabelMap mixed =
      testing::labelled_lattice({3, 2, 4}, 2 * Mat3::Identity(), [&](const Vec3&) { return next++ % 5; });
  for (const auto& [name, map] : {std::pair<std::string, LabelMap>("torus", torus), {"mixed", mixed}}) {
    const std::string voxels = testing::voxel_bytes<std::uint16_t>(map);
    const std::string nrrd = testing::nrrd_header(map), meta = testing::meta_header(map);
    write_file(folder / (name + ".nii"), testing::nifti_bytes(map));
    write_file(folder / (name + "_float.nii"), testing::nifti_bytes<float>(map, 16, true));
    write_file(folder / (name + ".nii.gz"), testing::packed(testing::nifti_bytes(map)));
    write_file(folder / (name + ".nrrd"), nrrd + "encoding: raw\n\n" + voxels);
    write_file(folder / (name + "_gzip.nrrd"), nrrd + "encoding: gzip\n\n" + testing::packed(voxels));
    write_file(folder / (name + "_at_end.mha"), meta + "HeaderSize = -1\nElementDataFile = LOCAL\n" + voxels);
    write_file(folder / (name + ".mha"), meta + "ElementDataFile = LOCAL\n" + voxels);
    write_file(folder / (name + "_zlib.mha"),
               meta + "CompressedData = True\nElementDataFile = LOCAL\n" + testing::packed(voxels, false));
  }
}

}  // namespace
}  // namespace foramen

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: make_corpus FOLDER\n");
    return 2;
  }
  try {
    const std::filesystem::path folder = argv[1];
    for (const char* target : {"mesh", "model", "repair", "label", "exchange"})
      std::filesystem::create_directories(folder / target);
    foramen::write_meshes(folder / "mesh");
    foramen::write_models(folder / "model");
    foramen::write_soups(folder / "repair");
    foramen::write_label_maps(folder / "label");
    foramen::write_exchange_files(folder / "exchange");
    return 0;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "make_corpus: %s\n", e.what());
    return 1;
  }
}
