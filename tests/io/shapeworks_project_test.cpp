#include "io/shapeworks_project.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "io/scalismo_landmarks.hpp"
#include "support/temporary_folder.hpp"

namespace foramen {
namespace {

using testing::bytes_of;
using ::testing::HasSubstr;
using testing::TemporaryFolder;

template <class Read>
std::string refusal(const Read& read) {
  try {
    read();
  } catch (const Error& e) {
    return e.what();
  }
  return "not refused";
}

TEST(Particles, RoundTripEndsWithALineEnd) {
  const TemporaryFolder folder;
  const std::vector<Vec3> particles{{1.0 / 3, 2, -3}, {1e-12, 0, 123456.789012345}};
  write_particles(folder.file("a.particles"), particles);
  EXPECT_TRUE(bytes_of(folder.file("a.particles")).ends_with("123456.789012345\n"));
  EXPECT_EQ(read_particles(folder.file("a.particles")), particles);
}

TEST(Particles, WhatIsNoneIsRefused) {
  const TemporaryFolder folder;
  EXPECT_THAT(refusal([&] { read_particles(folder.file("a", "1 2 3\n4 5\n")); }), HasSubstr("line 2"));
  EXPECT_THAT(refusal([&] { read_particles(folder.file("a", "\n\n")); }), HasSubstr("no particles"));
  EXPECT_THROW(write_particles(folder.file("b"), {}), InvalidInput);
  EXPECT_EQ(read_particles(folder.file("a", "1 2 3\n4 5 6")).size(), 2U);  // the last line has no line end
}

TEST(ShapeWorksProject, RoundTrip) {
  const TemporaryFolder folder;
  std::vector<ShapeWorksSubject> subjects(2);
  subjects[0] = {"a", "in/a.ply", "groomed/a.ply", "p/a_local.particles", "p/a_world.particles", {}, {}};
  subjects[0].alignment.setIdentity();
  subjects[0].procrustes << 0, -1, 0, 1.0 / 3, 1, 0, 0, 2, 0, 0, 1, -3, 0, 0, 0, 1;
  subjects[1].name = "b";
  write_shapeworks(folder.file("x.swproj"), subjects, 77);
  const std::string text = bytes_of(folder.file("x.swproj"));
  EXPECT_THAT(text, HasSubstr("\"procrustes_1\": \"0 -1 0 0.3333333333333333 1 0 0 2 0 0 1 -3 0 0 0 1\""));
  EXPECT_THAT(text, HasSubstr("\"number_of_particles\": \"77\""));
  const auto read = read_shapeworks(folder.file("x.swproj"));
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].name, "a");
  EXPECT_EQ(read[0].shape, "in/a.ply");
  EXPECT_EQ(read[0].groomed, "groomed/a.ply");
  EXPECT_EQ(read[0].local_particles, "p/a_local.particles");
  EXPECT_EQ(read[0].world_particles, "p/a_world.particles");
  EXPECT_EQ(read[0].procrustes, subjects[0].procrustes);
  EXPECT_TRUE(read[1].alignment.isIdentity(0));
}

// Variants that other programs write: another name of the domain, backslashes, no name, null parameters, a
// transform of twelve numbers.
TEST(ShapeWorksProject, ProjectsOfOthers) {
  const TemporaryFolder folder;
  const auto file = folder.file(
      "x.swproj",
      R"({"data":[{"mesh_spine":"in\\s.ply","local_particles_spine":".\\p\\s.particles",)"
      R"("alignment_spine":"0 0 0 0 0 0 0 0 0 4 5 6","group_sex":"f"}],"groom":null,"optimize":null})");
  const auto read = read_shapeworks(file);
  EXPECT_EQ(read.at(0).name, "s");
  EXPECT_EQ(read.at(0).local_particles, "./p/s.particles");
  EXPECT_EQ(read.at(0).alignment(1, 3), 5);
  EXPECT_EQ(read.at(0).alignment(0, 0), 1);
}

TEST(ShapeWorksProject, ColumnsOfAnyType) {
  const TemporaryFolder folder;
  const auto read = read_shapeworks(folder.file(
      "x.swproj",
      R"({"data":[{"name":7,"shape_1":"a.ply","age":61,"fixed":true,"note":null,"tags":["a",{"b":1}],)"
      R"("local_particles_1":"a.particles","shape_2":""}]})"));
  EXPECT_EQ(read.at(0).name, "7");
  EXPECT_EQ(read.at(0).shape, "a.ply");
}

TEST(ShapeWorksProject, WhatIsNoneIsRefused) {
  const TemporaryFolder folder;
  const auto refused = [&](std::string_view bytes) {
    return refusal([&] { read_shapeworks(folder.file("a.swproj", bytes)); });
  };
  EXPECT_THAT(refused("not json"), HasSubstr("is not JSON"));
  EXPECT_THAT(refused(R"({"data":[]})"), HasSubstr("no list of subjects"));
  EXPECT_THAT(refused(R"({"data":[{"name":["a"]}]})"), HasSubstr("subject 1 its 'name' is no text"));
  EXPECT_THAT(refused(R"({"data":[{"shape_a":"a","shape_b":"b"}]})"), HasSubstr("2 domains"));
  EXPECT_THAT(refused(R"({"data":[{"shape_1":"a","procrustes_1":"1 2 3"}]})"), HasSubstr("3 numbers"));
  EXPECT_THAT(refused(R"({"data":[{}]})"), HasSubstr("neither a name nor a file"));
}

TEST(ScalismoLandmarks, RoundTripAndFilesOfOthers) {
  const TemporaryFolder folder;
  const std::vector<ScalismoLandmark> landmarks{{"tip", {12.5, -3, 1.0 / 3}, "process"},
                                                {"0", {1, 2, 3}, ""}};
  write_scalismo_landmarks(folder.file("a.json"), landmarks);
  const auto read = read_scalismo_landmarks(folder.file("a.json"));
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].id, "tip");
  EXPECT_EQ(read[0].position, landmarks[0].position);
  EXPECT_EQ(read[0].description, "process");
  const auto file =
      folder.file("b.json", R"([{"id":"A","coordinates":[1,2,3],"extensions":{"x":1},)"
                            R"("uncertainty":{"stddevs":[1,1,1],"pcvectors":[[1,0,0],[0,1,0],[0,0,1]]}}])");
  EXPECT_EQ(read_scalismo_landmarks(file).at(0).position, Vec3(1, 2, 3));
}

TEST(ScalismoLandmarks, WhatIsNoneIsRefused) {
  const TemporaryFolder folder;
  const auto refused = [&](std::string_view bytes) {
    return refusal([&] { read_scalismo_landmarks(folder.file("a.json", bytes)); });
  };
  EXPECT_THAT(refused("{}"), HasSubstr("no list"));
  EXPECT_THAT(refused(R"([{"coordinates":[1,2,3]}])"), HasSubstr("landmark 1 has no id"));
  EXPECT_THAT(refused(R"([{"id":"a","coordinates":[1,2]}])"), HasSubstr("three coordinates"));
  EXPECT_THAT(refused(R"([{"id":"a","coordinates":[1,2,"3"]}])"), HasSubstr("no number"));
  EXPECT_THAT(refused(R"([{"id":"a","coordinates":[1,2,3]},{"id":"a","coordinates":[1,2,3]}])"),
              HasSubstr("landmark 2 has the id"));
  const std::vector<ScalismoLandmark> twice{{"a", {1, 2, 3}, ""}, {"a", {1, 2, 3}, ""}};
  EXPECT_THROW(write_scalismo_landmarks(folder.file("b.json"), twice), InvalidInput);
}

}  // namespace
}  // namespace foramen
