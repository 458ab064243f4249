#include "io/hdf5_json_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "foramen/io/statismo_file.hpp"
#include "support/meshes.hpp"
#include "support/temporary_folder.hpp"

namespace foramen {
namespace {

using testing::bytes_of;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::TemporaryFolder;

StatismoModel example() {
  StatismoModel model;
  const TriangleSoup soup = testing::torus_soup(6, 5);
  model.points = soup.points;
  model.triangles = soup.triangles;
  const auto numbers = static_cast<Eigen::Index>(3 * soup.points.size());
  model.mean = Eigen::VectorXd::LinSpaced(numbers, -1.0 / 3, 7);
  model.basis = Eigen::MatrixXd::Identity(numbers, 2);
  model.variance = Eigen::Vector2d(2.5, 0.1);
  model.scores = Eigen::MatrixXd::Constant(2, 3, -0.7);
  model.shape_uris = {"a.ply", "L1 \"x\".ply", "c.ply"};
  model.landmark_weights.assign(soup.points.size(), 0.1);
  model.parameters = {{"command", "foramen build"}};
  return model;
}

std::string refusal(const std::filesystem::path& file) {
  try {
    read_statismo(file);
  } catch (const IoError& e) {
    return e.what();
  }
  return "not refused";
}

TEST(Hdf5Json, HoldsToTheBitWhatHdf5Holds) {
  const TemporaryFolder folder;
  write_statismo(folder.file("a.h5"), example());
  write_statismo(folder.file("a.h5.json"), example());
  write_statismo(folder.file("again.h5.json"), example());
  EXPECT_EQ(bytes_of(folder.file("a.h5.json")), bytes_of(folder.file("again.h5.json")));
  write_statismo(folder.file("b.h5"), read_statismo(folder.file("a.h5.json")));
  EXPECT_EQ(bytes_of(folder.file("a.h5")), bytes_of(folder.file("b.h5")));
  write_statismo(folder.file("b.h5.json"), read_statismo(folder.file("a.h5")));
  EXPECT_EQ(bytes_of(folder.file("a.h5.json")), bytes_of(folder.file("b.h5.json")));
}

TEST(Hdf5Json, LayoutIsThatOfHdf5Json) {
  H5JsonWriter writer;
  writer.string("/info/name", "x");
  writer.group("/empty");
  writer.attribute("/empty", "kind", "none");
  writer.matrix<std::int32_t>("/m", {2, 3, {1, 2, 3, 4, 5, 6}});
  const std::string text = writer.text();
  EXPECT_THAT(
      text, HasSubstr(R"("shape":{"class":"H5S_SIMPLE","dims":[2,3]},)"
                      R"("type":{"class":"H5T_INTEGER","base":"H5T_STD_I32LE"},"value":[[1,2,3],[4,5,6]])"));
  EXPECT_THAT(text, HasSubstr(R"("alias":["/info/name"],"shape":{"class":"H5S_SCALAR"})"));
  EXPECT_THAT(text, HasSubstr(R"("name":"kind")"));
  const TemporaryFolder folder;
  const H5JsonReader reader(folder.file("a.json", text));
  EXPECT_THAT(reader.children(""), ElementsAre("empty", "info", "m"));
  EXPECT_EQ(reader.string("/info/name"), "x");
  EXPECT_EQ(reader.attribute("/empty", "kind"), "none");
  EXPECT_THAT(reader.matrix<std::int32_t>("/m").values, ElementsAre(1, 2, 3, 4, 5, 6));
  EXPECT_THROW(reader.matrix<float>("/missing"), IoError);
  EXPECT_THROW(reader.scalar<float>("/info/name"), IoError);
}

TEST(Hdf5Json, WhatJsonCannotHoldIsRefused) {
  H5JsonWriter writer;
  EXPECT_THROW(writer.string("/a", "\xff"), InvalidInput);
  EXPECT_THROW(writer.scalar("/b", std::numeric_limits<float>::quiet_NaN()), InvalidInput);
}

TEST(Hdf5Json, DamagedFilesAreRefused) {
  const TemporaryFolder folder;
  write_statismo(folder.file("a.h5.json"), example());
  const std::string good = bytes_of(folder.file("a.h5.json"));
  EXPECT_THAT(refusal(folder.file("cut.json", good.substr(0, good.size() / 2))), HasSubstr("is not JSON"));
  EXPECT_THAT(refusal(folder.file("empty.json", "{}")), HasSubstr("has no root"));
  const auto replaced = [&](const std::string& what, const std::string& by) {
    std::string bytes = good;
    const auto at = bytes.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return folder.file("replaced.json", bytes.replace(at, what.size(), by));
  };
  EXPECT_THAT(refusal(replaced("\"dims\":[2]", "\"dims\":[3]")), HasSubstr("has another shape than it says"));
  EXPECT_THAT(refusal(replaced("\"value\":[2.5,0.1]", "\"value\":[2.5,\"x\"]")), HasSubstr("no number"));
  EXPECT_THAT(refusal(replaced("POLYGON_MESH", "VOLUME_MESH")), HasSubstr("not a POLYGON_MESH"));
  EXPECT_THAT(refusal(replaced("\"title\":\"mean\"", "\"title\":\"main\"")), HasSubstr("/model/mean"));
}

TEST(Hdf5Json, LinksInACircleAreRefused) {
  const TemporaryFolder folder;
  const auto file =
      folder.file("circle.json", R"({"root":"a","groups":{"a":{"links":[{"collection":"groups","id":"a",)"
                                 R"("title":"again"}]}},"datasets":{}})");
  EXPECT_THAT(refusal(file), HasSubstr("linked twice"));
}

}  // namespace
}  // namespace foramen
