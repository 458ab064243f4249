#include "exchange/convert.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "foramen/core/error.hpp"
#include "foramen/core/rng.hpp"
#include "foramen/io/statismo_file.hpp"
#include "io/atomic_file.hpp"
#include "io/named_points.hpp"
#include "io/scalismo_landmarks.hpp"
#include "io/shapeworks_project.hpp"
#include "io/table_file.hpp"
#include "io/zip_bytes.hpp"
#include "modelfiles/corresponding_folder.hpp"
#include "support/meshes.hpp"
#include "support/messages.hpp"
#include "support/temporary_folder.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using testing::bytes_of;
using testing::offers;
using testing::says;
using testing::TemporaryFolder;

// Coordinates have single precision and the size of a vertebra.
constexpr double tolerance = 1e-4;

// Five shapes of the size of vertebrae in folder/meshes, in the single precision of PLY files.
class Convert : public ::testing::Test {
 protected:
  void SetUp() override {
    TriangleSoup soup = testing::torus_soup(8, 6);
    Rng rng(3);
    fs::create_directories(meshes());
    for (int i = 0; i < 5; ++i) {
      TriangleSoup shape = soup;
      for (Vec3& p : shape.points)
        for (int k = 0; k < 3; ++k) p[k] = static_cast<float>(p[k] + rng.normal() + 30 * i);
      write_ply(meshes() / ("L" + std::to_string(i) + ".ply"), shape);
    }
  }
  fs::path meshes() const { return folder_.file("meshes"); }
  fs::path file(const std::string& name) const { return folder_.file(name); }
  ConvertSummary converted(const fs::path& input, const fs::path& output, ConvertRequest more = {}) const {
    more.input = input;
    more.output = output;
    return convert(more, RunContext(1));
  }
  Message refusal(const fs::path& input, const fs::path& output, const ConvertRequest& more = {}) const {
    return testing::refusal([&] { converted(input, output, more); });
  }
  void expect_the_same_meshes(const fs::path& folder) const {
    const CorrespondingFolder a = read_corresponding(meshes()), b = read_corresponding(folder);
    EXPECT_EQ(a.names, b.names);
    EXPECT_EQ(a.triangles, b.triangles);
    EXPECT_EQ(a.shapes, b.shapes);
  }

 private:
  TemporaryFolder folder_;
};

// Converting to each format that holds the shapes' own coordinates, and back, gives the same meshes.
TEST_F(Convert, ShapesComeBackTheSame) {
  const ConvertRequest with_triangles{.input = {}, .output = {}, .triangles = meshes() / "L0.ply"};
  for (const char* name : {"a.tps", "a.csv", "study/a.swproj"}) {
    SCOPED_TRACE(name);
    EXPECT_EQ(converted(meshes(), file(name)).shapes, 5U);
    const fs::path back = file("back_" + fs::path(name).extension().string().substr(1));
    converted(file(name), back, with_triangles);
    expect_the_same_meshes(back);
  }
  converted(meshes(), file("vtp"), {.input = {}, .output = {}, .format = ExchangeFormat::vtp});
  converted(file("vtp"), file("back"));
  expect_the_same_meshes(file("back"));
}

// Without a project the particles of each subject are taken in its own coordinates, where there are both.
TEST_F(Convert, AFolderOfParticles) {
  converted(meshes(), file("study/a.swproj"));
  const ConvertRequest with_triangles{.input = {}, .output = {}, .triangles = meshes() / "L0.ply"};
  EXPECT_EQ(converted(file("study/particles"), file("back"), with_triangles).shapes, 5U);
  expect_the_same_meshes(file("back"));
}

TEST_F(Convert, AProjectInASpreadsheet) {
  converted(meshes(), file("study/a.swproj"));
  std::string rows = "<row><c t=\"str\"><v>name</v></c><c t=\"str\"><v>local_particles_1</v></c></row>";
  for (int i = 0; i < 5; ++i) {
    const std::string name = "L" + std::to_string(i);
    rows += "<row><c t=\"str\"><v>" + name + "</v></c><c t=\"str\"><v>particles/" + name +
            "_local.particles</v></c></row>";
  }
  write_file(file("study/a.xlsx"), testing::zip_bytes(testing::spreadsheet(rows)));
  const ConvertRequest with_triangles{.input = {}, .output = {}, .triangles = meshes() / "L0.ply"};
  EXPECT_EQ(converted(file("study/a.xlsx"), file("back"), with_triangles).shapes, 5U);
  expect_the_same_meshes(file("back"));
}

TEST_F(Convert, ShapesMakeAModelThatHoldsThem) {
  const ConvertSummary summary = converted(meshes(), file("model.h5"));
  EXPECT_EQ(summary.landmarks, 48U);
  const StatismoModel model = read_statismo(file("model.h5"));
  EXPECT_EQ(model.variance.size(), 4);
  EXPECT_EQ(model.shape_uris.front(), "L0");
  // The training shapes of the model are the meshes, except for a rigid motion.
  converted(file("model.h5"), file("aligned"));
  const CorrespondingFolder a = read_corresponding(meshes()), b = read_corresponding(file("aligned"));
  for (std::size_t i = 0; i < a.shapes.size(); ++i) {
    const SimilarityTransform motion = fit_similarity(a.shapes[i], b.shapes[i], ScaleMode::keep);
    for (std::size_t v = 0; v < a.shapes[i].size(); ++v)
      EXPECT_LT((motion(a.shapes[i][v]) - b.shapes[i][v]).norm(), tolerance);
  }
}

TEST_F(Convert, ModelsGoThroughJsonUnchanged) {
  converted(meshes(), file("a.h5"));
  converted(file("a.h5"), file("b.h5.json"));
  converted(file("b.h5.json"), file("c.h5"));
  EXPECT_EQ(bytes_of(file("a.h5")), bytes_of(file("c.h5")));
}

TEST_F(Convert, ScoresAreThoseOfTheModel) {
  converted(meshes(), file("a.h5"));
  converted(file("a.h5"), file("scores.csv"),
            {.input = {}, .output = {}, .format = ExchangeFormat::score_table});
  const Table table = read_csv(file("scores.csv"));
  const Eigen::MatrixXd scores = read_statismo(file("a.h5")).scores;
  EXPECT_EQ(table.rows.at(2).at(0), "L2");
  EXPECT_EQ(parse_number(table.rows.at(2).at(table.column("mode3"))), scores(2, 2));
}

// The transforms of the project map local particles to world particles, in which all shapes are near each
// other.
TEST_F(Convert, ProjectOfShapeWorksHangsTogether) {
  converted(meshes(), file("a.swproj"));
  const auto subjects = read_shapeworks(file("a.swproj"));
  ASSERT_EQ(subjects.size(), 5U);
  Vec3 first = Vec3::Zero();
  for (const ShapeWorksSubject& subject : subjects) {
    const auto local = read_particles(file(subject.local_particles.string()));
    const auto world = read_particles(file(subject.world_particles.string()));
    EXPECT_EQ(read_mesh(file(subject.groomed.string())).soup.points, local);
    for (std::size_t i = 0; i < local.size(); ++i)
      EXPECT_LT(((subject.procrustes * local[i].homogeneous()).head<3>() - world[i]).norm(), 1e-9);
    if (subject.name == "L0") first = world[0];
    EXPECT_LT((world[0] - first).norm(), 10);  // the meshes themselves lie 50 mm apart
  }
}

TEST_F(Convert, RasIsTurnedToLps) {
  const CorrespondingFolder lps = read_corresponding(meshes());
  fs::create_directories(file("ras"));
  for (std::size_t i = 0; i < lps.names.size(); ++i) {
    TriangleSoup soup{lps.shapes[i], lps.triangles};
    for (Vec3& p : soup.points) p = Vec3(-p.x(), -p.y(), p.z());
    write_ply(file("ras") / (lps.names[i] + ".ply"), soup, AnatomicalSpace::ras);
  }
  const ConvertSummary summary = converted(file("ras"), file("turned"));
  EXPECT_THAT(summary.notes, ::testing::Contains(says("5 of 5 meshes are in RAS")));
  expect_the_same_meshes(file("turned"));
  EXPECT_EQ(read_mesh(file("turned") / "L0.ply").space, AnatomicalSpace::lps);
}

TEST_F(Convert, UnitsBecomeMillimetres) {
  const ConvertRequest metres{.input = {}, .output = {}, .unit = LengthUnit::metre};
  const ConvertRequest centimetres{.input = {}, .output = {}, .unit = LengthUnit::centimetre};
  const ConvertRequest certain{.input = {}, .output = {}, .unit = {LengthUnit::millimetre, true}};
  EXPECT_THAT(refusal(meshes(), file("m.tps"), metres), offers({{RemedyKind::leave_unit_out}}));
  fs::create_directories(file("cm"));
  for (int i = 0; i < 2; ++i) {
    TriangleSoup soup = read_mesh(meshes() / ("L" + std::to_string(i) + ".ply")).soup;
    for (Vec3& p : soup.points) p *= 0.1;
    write_ply(file("cm") / ("L" + std::to_string(i) + ".ply"), soup);
  }
  EXPECT_THAT(refusal(file("cm"), file("c.tps")), offers({{RemedyKind::give_unit, "cm"}}));
  EXPECT_THAT(converted(file("cm"), file("c.tps"), centimetres).notes, ::testing::IsEmpty());
  EXPECT_LT(
      (read_tps(file("c.tps")).specimens[1].points[3] - read_corresponding(meshes()).shapes[1][3]).norm(),
      tolerance);
  EXPECT_THAT(converted(file("cm"), file("d.tps"), certain).notes,
              ::testing::ElementsAre(says("2 of 2 shapes are not the size of a vertebra")));
  EXPECT_THAT(refusal(file("d.tps"), file("e.csv")), offers({{RemedyKind::give_unit, "cm"}}))
      << "points without triangles are checked too";
  converted(meshes(), file("a.h5"));
  EXPECT_THAT(refusal(file("a.h5"), file("b.tps"), metres),
              AllOf(says("a model is in mm"), offers({{RemedyKind::leave_unit_out}})));
}

TEST_F(Convert, LandmarksForScalismo) {
  converted(meshes(), file("landmarks"),
            {.input = {}, .output = {}, .format = ExchangeFormat::scalismo_landmarks});
  const auto landmarks = read_scalismo_landmarks(file("landmarks") / "L3.json");
  EXPECT_EQ(landmarks.at(5).id, "5");
  EXPECT_EQ(landmarks.at(5).position, read_corresponding(meshes()).shapes[3][5]);
}

TEST_F(Convert, WhatCannotBeIsRefused) {
  EXPECT_THAT(refusal(file("nothing"), file("a.h5")), says("no such file or folder"));
  EXPECT_THAT(refusal(meshes() / "L0.ply", file("a.h5")), says("none of what can be converted"));
  EXPECT_THAT(refusal(meshes(), file("a.ply")), offers({{RemedyKind::choose_format, "ply"}}));
  EXPECT_THAT(
      refusal(meshes(), file("a.txt"), {.input = {}, .output = {}, .format = ExchangeFormat::statismo}),
      says("ends in .h5"));
  EXPECT_THAT(refusal(meshes(), meshes() / "model.h5"), says("lies in the folder"));
  converted(meshes(), file("a.tps"));
  EXPECT_THAT(refusal(file("a.tps"), file("a.h5")), offers({{RemedyKind::give_triangles}}));
  write_ply(file("small.ply"), testing::torus_soup(5, 4));
  EXPECT_THAT(
      refusal(file("a.tps"), file("a.h5"), {.input = {}, .output = {}, .triangles = file("small.ply")}),
      says("has 20 vertices"));
  // Meshes of another set would be taken for a part of this one.
  fs::create_directories(file("full"));
  write_ply(file("full") / "old.ply", testing::torus_soup(5, 4));
  EXPECT_THAT(refusal(meshes(), file("full")), says("old.ply"));
  EXPECT_FALSE(fs::exists(file("full") / "L0.ply"));
  // A name in a file must not lead to a path outside the folder.
  std::ofstream(file("evil.tps")) << "LM3=1\n1 2 3\nID=../evil\n";
  EXPECT_THAT(refusal(file("evil.tps"), file("out.csv")), says("cannot be that of a file"));
}

TEST_F(Convert, AModelWithoutScoresGivesTheModelAlone) {
  converted(meshes(), file("a.h5"));
  StatismoModel model = read_statismo(file("a.h5"));
  model.scores.resize(0, 0);
  write_statismo(file("plain.h5"), model);
  EXPECT_EQ(converted(file("plain.h5"), file("plain.h5.json")).shapes, 0U);
  EXPECT_THAT(refusal(file("plain.h5"), file("a.tps")), says("without scores"));
}

}  // namespace
}  // namespace foramen
