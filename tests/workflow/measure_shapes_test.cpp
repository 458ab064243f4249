#include "workflow/measure_shapes.hpp"

#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "foramen/io/mesh_file.hpp"
#include "support/meshes.hpp"
#include "support/messages.hpp"
#include "support/temporary_folder.hpp"

namespace foramen {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TriangleSoup sized_torus(double size) { return testing::torus_soup(24, 12, 20 * size, 8 * size); }

// A model without variation, because only its mean matters here.
ShapeModel torus_model() {
  const TriangleSoup mean = sized_torus(1);
  return {flattened(mean.points), Eigen::MatrixXd(3 * mean.points.size(), 0), Eigen::VectorXd(0),
          mean.triangles};
}

// From the outermost point to the opposite one.
MeasureDefinitions width_of_torus() {
  return {{{"east", Vec3(30, 0, 0)}, {"west", Vec3(-30, 0, 0)}}, {{"width", "east", "west"}}, {}};
}

Measurer torus_measurer() { return measurer_of(torus_model(), width_of_torus(), "measures.json"); }

template <class Work>
std::string measuring_refusal(const Work& work) {
  try {
    work();
  } catch (const InvalidInput& e) {
    return e.what();
  }
  ADD_FAILURE() << "not refused";
  return {};
}

TEST(MeasurerOf, MeasuresTheMeanOfTheModel) {
  const ShapeMeasures measures = torus_measurer()(build_mesh(sized_torus(1)));
  EXPECT_NEAR(measures.distances.at(0), 56, 1e-9);
}

TEST(MeasurerOf, NamesTheFileOfAWrongDefinition) {
  MeasureDefinitions wrong = width_of_torus();
  wrong.distances[0].to = "north";
  const std::string said = measuring_refusal([&] { measurer_of(torus_model(), wrong, "measures.json"); });
  EXPECT_THAT(said, HasSubstr("measures.json: "));
  EXPECT_THAT(said, HasSubstr("north"));
}

TEST(MeasureFiles, OfAFolderInOrderOfStemAndInMillimetres) {
  const testing::TemporaryFolder folder;
  for (const auto& [name, size] : {std::pair{"b.ply", 0.2}, {"a.ply", 0.1}, {"c.ply", 0.3}})
    write_ply(folder.file(name), sized_torus(size));
  const auto shapes =
      measure_files(torus_measurer(), {folder.path()}, LengthUnit::centimetre, RunContext(1)).shapes;
  ASSERT_EQ(shapes.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(shapes[i].name, std::string(1, "abc"[i]));
    EXPECT_NEAR(shapes[i].measures.distances.at(0), 56.0 * static_cast<double>(i + 1), 1e-4);
  }
}

TEST(MeasureFiles, NamesTheFileThatHasNotTheModelsTriangles) {
  const testing::TemporaryFolder folder;
  write_ply(folder.file("good.ply"), sized_torus(1));
  write_ply(folder.file("other.ply"), testing::torus_soup(20, 10));
  const auto measure = [&] {
    measure_files(torus_measurer(), {folder.path()}, LengthUnit::millimetre, RunContext(1));
  };
  EXPECT_THAT(measuring_refusal(measure), HasSubstr("other.ply: "));
}

TEST(MeasureFiles, RefusesASizeThatNoVertebraHasUnlessTheUnitIsCertain) {
  const testing::TemporaryFolder folder;
  for (const char* name : {"a.ply", "b.ply"}) write_ply(folder.file(name), sized_torus(0.001));
  const auto measured = [&](const InputUnit& unit) {
    return measure_files(torus_measurer(), {folder.path()}, unit, RunContext(1));
  };
  EXPECT_THAT(testing::refusal([&] { measured({}); }),
              AllOf(testing::says("a.ply: "), testing::offers({{RemedyKind::give_unit, "m"}})));
  EXPECT_THAT(measured(LengthUnit::metre).notes, IsEmpty());
  const MeasuredFiles certain = measured({LengthUnit::millimetre, true});
  EXPECT_NEAR(certain.shapes.at(0).measures.distances.at(0), 0.056, 1e-6);
  EXPECT_THAT(certain.notes, ElementsAre(testing::says("2 of 2 shapes are not the size of a vertebra")));
}

TEST(MeasureFiles, SaysHowFarItIsAndStopsWhenAsked) {
  const testing::TemporaryFolder folder;
  for (const char* name : {"a.ply", "b.ply"}) write_ply(folder.file(name), sized_torus(1));
  std::vector<double> fractions;
  const RunContext ctx(1, [&](const Progress& p) { fractions.push_back(p.fraction); });
  measure_files(torus_measurer(), {folder.path()}, LengthUnit::millimetre, ctx);
  EXPECT_THAT(fractions, ::testing::ElementsAre(0, 0.5));
  ctx.request_stop();
  EXPECT_THROW(measure_files(torus_measurer(), {folder.path()}, LengthUnit::millimetre, ctx), Cancelled);
}

}  // namespace
}  // namespace foramen
