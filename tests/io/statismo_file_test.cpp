#include "foramen/io/statismo_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <Eigen/QR>

#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>
#include <limits>
#include <memory>

#include "foramen/core/error.hpp"
#include "foramen/core/rng.hpp"
#include "io/hdf5_file.hpp"
#include "support/meshes.hpp"
#include "support/temporary_folder.hpp"

namespace foramen {
namespace {

using testing::bytes_of;
using ::testing::HasSubstr;
using testing::TemporaryFolder;

StatismoModel example() {
  StatismoModel model;
  const TriangleSoup soup = testing::bumpy_torus_soup(6, 5, 2);
  model.points = soup.points;
  model.triangles = soup.triangles;
  const auto numbers = static_cast<Eigen::Index>(3 * soup.points.size());
  constexpr Eigen::Index modes = 4, shapes = 5;
  Rng rng(3);
  const auto random = [&](Eigen::Index rows, Eigen::Index cols) {
    return Eigen::MatrixXd(Eigen::MatrixXd::NullaryExpr(rows, cols, [&] { return rng.normal(); }));
  };
  model.mean = random(numbers, 1);
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(random(numbers, modes));
  model.basis = qr.householderQ() * Eigen::MatrixXd::Identity(numbers, modes);
  model.variance = Eigen::Vector4d(9, 4, 1, 0.25);
  model.noise_variance = 0.125;
  model.scores = random(modes, shapes);
  for (int i = 0; i < shapes; ++i) model.shape_uris.push_back("L" + std::to_string(i) + ".ply");
  model.parameters = {{"lambda", "0.5"}, {"seed", "1"}};
  return model;
}

// A basis of a Gaussian process: the covariance and the training shapes must stay what they are.
TEST(Statismo, ABasisThatIsNotOrthonormalGivesTheSameCovariance) {
  const TemporaryFolder folder;
  StatismoModel model = example();
  Eigen::Matrix4d mixed;
  mixed << 30, 1, 0, 0, 2, 20, 3, 0, 0, -5, 10, 1, 4, 0, 0, 0.5;
  model.basis = model.basis * mixed;
  model.noise_variance = 0.25;
  const Eigen::MatrixXd covariance = model.basis * model.variance.asDiagonal() * model.basis.transpose(),
                        offsets = model.basis * model.variance.cwiseSqrt().asDiagonal() * model.scores;
  for (const char* name : {"model.h5", "model.h5.json"}) {
    SCOPED_TRACE(name);
    write_statismo(folder.file(name), model);
    const StatismoModel read = read_statismo(folder.file(name));
    ASSERT_EQ(read.basis.cols(), 4);
    EXPECT_TRUE((read.basis.transpose() * read.basis).isIdentity(1e-6));
    EXPECT_TRUE(std::is_sorted(read.variance.begin(), read.variance.end(), std::greater<>()));
    const Eigen::MatrixXd found = read.basis * read.variance.asDiagonal() * read.basis.transpose();
    EXPECT_TRUE(found.isApprox(covariance, 1e-5));
    EXPECT_TRUE((read.basis * read.variance.cwiseSqrt().asDiagonal() * read.scores).isApprox(offsets, 1e-5));
    EXPECT_EQ(read.noise_variance, 0.25);
    ASSERT_EQ(read.notes.size(), 1u);
    EXPECT_THAT(read.notes[0].text, HasSubstr("are not orthonormal"));
  }
  model.basis.col(3) = model.basis.col(0);  // only three modes are independent
  write_statismo(folder.file("model.h5"), model);
  const StatismoModel dependent = read_statismo(folder.file("model.h5"));
  EXPECT_EQ(dependent.basis.cols(), 3);
  EXPECT_EQ(dependent.scores.rows(), 3);
}

TEST(Statismo, RoundTripToSinglePrecision) {
  const TemporaryFolder folder;
  const StatismoModel model = example();
  write_statismo(folder.file("model.h5"), model);
  const StatismoModel read = read_statismo(folder.file("model.h5"));
  constexpr double ulp = std::numeric_limits<float>::epsilon();
  EXPECT_TRUE(read.mean.isApprox(model.mean, ulp));
  EXPECT_TRUE(read.basis.isApprox(model.basis, ulp));
  EXPECT_TRUE(read.scores.isApprox(model.scores, ulp));
  EXPECT_EQ(read.variance, model.variance);
  EXPECT_EQ(read.noise_variance, model.noise_variance);
  EXPECT_EQ(read.triangles, model.triangles);
  ASSERT_EQ(read.points.size(), model.points.size());
  for (std::size_t i = 0; i < read.points.size(); ++i)
    EXPECT_TRUE(read.points[i].isApprox(model.points[i], ulp));
  EXPECT_EQ(read.shape_uris, model.shape_uris);
  EXPECT_EQ(read.parameters, model.parameters);
  EXPECT_EQ(read.build_time, model.build_time);
  EXPECT_EQ(read.builder_name, "foramen");
}

TEST(Statismo, InSinglePrecisionIsWhatIsReadBack) {
  const TemporaryFolder folder;
  StatismoModel model = example();
  model.noise_variance = 0.1;
  write_statismo(folder.file("model.h5"), model);
  const StatismoModel read = read_statismo(folder.file("model.h5")), rounded = in_single_precision(model);
  EXPECT_NE(model.mean, rounded.mean);
  EXPECT_EQ(read.points, rounded.points);
  EXPECT_EQ(read.mean, rounded.mean);
  EXPECT_EQ(read.basis, rounded.basis);
  EXPECT_EQ(read.variance, rounded.variance);
  EXPECT_EQ(read.noise_variance, rounded.noise_variance);
  EXPECT_EQ(read.scores, rounded.scores);
}

// What is read was rounded already: writing it again changes nothing.
TEST(Statismo, SameBytesTwiceAndAfterReading) {
  const TemporaryFolder folder;
  write_statismo(folder.file("a.h5"), example());
  write_statismo(folder.file("b.h5"), example());
  write_statismo(folder.file("c.h5"), read_statismo(folder.file("a.h5")));
  EXPECT_EQ(bytes_of(folder.file("a.h5")), bytes_of(folder.file("b.h5")));
  EXPECT_EQ(bytes_of(folder.file("a.h5")), bytes_of(folder.file("c.h5")));
}

TEST(Statismo, ScoresAndNamesMayBeAbsent) {
  const TemporaryFolder folder;
  StatismoModel model = example();
  model.scores.resize(0, 0);
  model.shape_uris.clear();
  model.parameters.clear();
  write_statismo(folder.file("a.h5"), model);
  EXPECT_FALSE(H5Reader(folder.file("a.h5")).has("/modelinfo/scores"));
  const StatismoModel read = read_statismo(folder.file("a.h5"));
  EXPECT_EQ(read.scores.size(), 0);
  EXPECT_TRUE(read.shape_uris.empty() && read.parameters.empty());
}

// Landmark weights are an addition of foramen. They change nothing else in the file, and a model without
// weights has no such dataset.
TEST(Statismo, LandmarkWeightsStandBeside) {
  const TemporaryFolder folder;
  StatismoModel model = example();
  write_statismo(folder.file("plain.h5"), model);
  EXPECT_FALSE(H5Reader(folder.file("plain.h5")).has("/foramen"));
  EXPECT_TRUE(read_statismo(folder.file("plain.h5")).landmark_weights.empty());
  Rng rng(4);
  for (std::size_t i = 0; i < model.points.size(); ++i) model.landmark_weights.push_back(rng.uniform(0.1, 2));
  write_statismo(folder.file("a.h5"), model);
  StatismoModel read = read_statismo(folder.file("a.h5"));
  EXPECT_EQ(read.landmark_weights, model.landmark_weights);
  read.landmark_weights.clear();
  write_statismo(folder.file("b.h5"), read);
  EXPECT_EQ(bytes_of(folder.file("b.h5")), bytes_of(folder.file("plain.h5")));
}

// The order of coordinates is by axis in the representer and by point in the mean; that of cells is by
// corner.
TEST(Statismo, OrderOfNumbers) {
  const TemporaryFolder folder;
  const StatismoModel model = example();
  write_statismo(folder.file("a.h5"), model);
  const H5Reader file(folder.file("a.h5"));
  const auto points = file.matrix<float>("/representer/points");
  const auto cells = file.matrix<std::int32_t>("/representer/cells");
  const auto basis = file.matrix<float>("/model/pcaBasis");
  const auto mean = file.vector<float>("/model/mean");
  ASSERT_EQ(points.rows, 3U);
  ASSERT_EQ(cells.rows, 3U);
  EXPECT_EQ(points.values[2 * points.cols + 7], static_cast<float>(model.points[7].z()));
  EXPECT_EQ(cells.values[1 * cells.cols + 8], model.triangles[8][1]);
  EXPECT_EQ(basis.values[5 * basis.cols + 2], static_cast<float>(model.basis(5, 2)));
  EXPECT_EQ(mean[3 * 4 + 1], static_cast<float>(model.mean[13]));
}

std::string output_of(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen((command + " 2>&1").c_str(), "r"), pclose);
  std::string out;
  std::array<char, 4096> buffer{};
  while (pipe && std::fgets(buffer.data(), buffer.size(), pipe.get())) out += buffer.data();
  return out;
}

// The part of the dump about one object, up to the line of the next object.
std::string part(const std::string& dump, const std::string& object) {
  const auto at = dump.find(object);
  EXPECT_NE(at, std::string::npos) << object;
  if (at == std::string::npos) return {};
  std::string text = dump.substr(
      at, std::min(dump.find("DATASET \"", at + object.size()), dump.find("GROUP \"", at + 1)) - at);
  return text;
}

TEST(Statismo, LayoutAsH5dumpSeesIt) {
  if (output_of("h5dump --version").find("Version") == std::string::npos)
    GTEST_SKIP() << "h5dump is not installed";
  const TemporaryFolder folder;
  write_statismo(folder.file("a.h5"), example());
  const std::string dump = output_of("h5dump -H -p " + folder.file("a.h5").string());
  const auto f32 = HasSubstr("DATATYPE  H5T_IEEE_F32LE"), i32 = HasSubstr("DATATYPE  H5T_STD_I32LE");
  const auto scalar = HasSubstr("DATASPACE  SCALAR");
  const auto simple = [](const std::string& sizes) {
    return HasSubstr("DATASPACE  SIMPLE { ( " + sizes + " ) / ( " + sizes + " ) }");
  };
  for (const char* name : {"majorVersion", "minorVersion"})
    EXPECT_THAT(part(dump, std::string("DATASET \"") + name), ::testing::AllOf(i32, scalar));
  EXPECT_THAT(part(dump, "DATASET \"points"), ::testing::AllOf(f32, simple("3, 30")));
  EXPECT_THAT(part(dump, "DATASET \"cells"), ::testing::AllOf(i32, simple("3, 60")));
  EXPECT_THAT(part(dump, "DATASET \"mean"), ::testing::AllOf(f32, simple("90")));
  EXPECT_THAT(part(dump, "DATASET \"pcaBasis"), ::testing::AllOf(f32, simple("90, 4")));
  EXPECT_THAT(part(dump, "DATASET \"pcaVariance"), ::testing::AllOf(f32, simple("4")));
  EXPECT_THAT(part(dump, "DATASET \"noiseVariance"), ::testing::AllOf(f32, scalar));
  EXPECT_THAT(part(dump, "DATASET \"scores"), ::testing::AllOf(f32, simple("4, 5")));
  for (const char* name : {"build-time", "builderName", "buildTime", "URI_0", "lambda"})
    EXPECT_THAT(
        part(dump, std::string("DATASET \"") + name),
        ::testing::AllOf(scalar, HasSubstr("STRPAD H5T_STR_NULLTERM"), HasSubstr("CSET H5T_CSET_ASCII")));
  EXPECT_THAT(part(dump, "DATASET \"builderName"), HasSubstr("STRSIZE 8;"));  // "foramen" and its NUL
  for (const char* name : {"name", "version", "datasetType"})
    EXPECT_THAT(part(dump, std::string("ATTRIBUTE \"") + name + "\""),
                ::testing::AllOf(HasSubstr("STRPAD H5T_STR_NULLTERM"), HasSubstr("CSET H5T_CSET_ASCII"),
                                 simple("1")));
  for (const char* name : {"pointData", "cellData", "dataInfo", "parameters", "modelBuilder-0", "modelinfo"})
    EXPECT_THAT(dump, HasSubstr(std::string("GROUP \"") + name));
  EXPECT_THAT(dump, HasSubstr("CONTIGUOUS"));
  EXPECT_THAT(dump, ::testing::Not(HasSubstr("CHUNKED")));
  const std::string boot = output_of("h5dump -B -H " + folder.file("a.h5").string());
  EXPECT_THAT(boot, HasSubstr("SUPERBLOCK_VERSION 0"));
}

TEST(Statismo, RefusesToWriteWhatDoesNotFit) {
  const TemporaryFolder folder;
  const std::vector<std::function<void(StatismoModel&)>> mistakes = {
      [](StatismoModel& m) { m.points.clear(); },
      [](StatismoModel& m) { m.mean.conservativeResize(m.mean.size() - 1); },
      [](StatismoModel& m) { m.basis.conservativeResize(Eigen::NoChange, 3); },
      [](StatismoModel& m) { m.variance.resize(0); },
      [](StatismoModel& m) { m.scores.conservativeResize(3, Eigen::NoChange); },
      [](StatismoModel& m) { m.shape_uris.pop_back(); },
      [](StatismoModel& m) { m.mean[4] = std::numeric_limits<double>::quiet_NaN(); },
      [](StatismoModel& m) { m.variance[0] = 1e39; },
      [](StatismoModel& m) { m.triangles[0][2] = 30; },
      [](StatismoModel& m) { m.landmark_weights = {1}; },
      [](StatismoModel& m) { m.landmark_weights.assign(m.points.size(), 0.0); },
      [](StatismoModel& m) { m.parameters.emplace_back("a/b", "c"); },
      [](StatismoModel& m) { m.parameters.emplace_back("seed", "2"); }};
  for (std::size_t i = 0; i < mistakes.size(); ++i) {
    SCOPED_TRACE(i);
    StatismoModel model = example();
    mistakes[i](model);
    EXPECT_THROW(write_statismo(folder.file("a.h5"), model), InvalidInput);
  }
  EXPECT_EQ(folder.size(), 0);
}

TEST(Statismo, EachMistakeInAFileHasItsMessage) {
  const TemporaryFolder folder;
  // A small model of one triangle and one mode, with one dataset replaced.
  const auto message = [&](const std::string& changed,
                           const std::function<void(H5Writer&)>& change) -> std::string {
    write_h5(folder.file("a.h5"), [&](H5Writer& file) {
      const auto put = [&](const std::string& path, const std::function<void()>& usual) {
        if (path == changed)
          change(file);
        else
          usual();
      };
      put("/version/majorVersion", [&] { file.scalar<std::int32_t>("/version/majorVersion", 0); });
      put("/version/minorVersion", [&] { file.scalar<std::int32_t>("/version/minorVersion", 9); });
      file.group("/representer");
      put("kind", [&] { file.attribute("/representer", "datasetType", "POLYGON_MESH"); });
      put("points", [&] { file.matrix<float>("/representer/points", {3, 3, {0, 1, 0, 0, 0, 1, 0, 0, 0}}); });
      put("cells", [&] { file.matrix<std::int32_t>("/representer/cells", {3, 1, {0, 1, 2}}); });
      put("mean", [&] { file.vector<float>("/model/mean", std::vector<float>(9, 1.0F)); });
      put("basis", [&] { file.matrix<float>("/model/pcaBasis", {9, 1, {1, 0, 0, 0, 0, 0, 0, 0, 0}}); });
      put("variance", [&] { file.vector<float>("/model/pcaVariance", std::vector<float>{2}); });
      put("noise", [&] { file.vector<float>("/model/noiseVariance", std::vector<float>{0}); });
      put("weights", [] {});
      put("scores", [&] { file.matrix<float>("/modelinfo/scores", {1, 1, {0}}); });
    });
    try {
      read_statismo(folder.file("a.h5"));
      return "read";
    } catch (const IoError& error) {
      return error.what();
    }
  };
  EXPECT_EQ(message("nothing", {}), "read");
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THAT(message("/version/minorVersion", [](H5Writer&) {}),
              HasSubstr("/version: is missing, as in models before"));
  EXPECT_THAT(message("/version/minorVersion",
                      [](H5Writer& f) { f.scalar<std::int32_t>("/version/minorVersion", 8); }),
              HasSubstr("/version: is 0.8, not 0.9 or 1.x"));
  EXPECT_THAT(message("kind", [](H5Writer& f) { f.attribute("/representer", "datasetType", "IMAGE"); }),
              HasSubstr("is a IMAGE, not a POLYGON_MESH"));
  EXPECT_THAT(message("points",
                      [](H5Writer& f) {
                        f.matrix<float>("/representer/points", {2, 3, {0, 0, 0, 0, 0, 0}});
                      }),
              HasSubstr("/representer/points: has 2 rows"));
  EXPECT_THAT(message("points",
                      [&](H5Writer& f) {
                        f.matrix<float>("/representer/points", {3, 3, {0, 1, 0, 0, nan, 1, 0, 0, 0}});
                      }),
              HasSubstr("point 1 is not finite"));
  EXPECT_THAT(message("cells",
                      [](H5Writer& f) {
                        f.matrix<std::int32_t>("/representer/cells", {3, 1, {0, 1, 3}});
                      }),
              HasSubstr("triangle 0 uses point 3 of 3"));
  EXPECT_THAT(message("cells",
                      [](H5Writer& f) {
                        f.matrix<float>("/representer/cells", {3, 1, {0, 1, 2}});
                      }),
              HasSubstr("/representer/cells: holds no integers"));
  EXPECT_THAT(
      message("mean", [](H5Writer& f) { f.vector<float>("/model/mean", std::vector<float>(8, 1.0F)); }),
      HasSubstr("/model/mean: has 8 numbers instead of 9"));
  EXPECT_THAT(message("mean",
                      [](H5Writer& f) {
                        f.matrix<float>("/model/mean", {9, 1, std::vector<float>(9, 1.0F)});
                      }),
              HasSubstr("/model/mean: has shape (9 x 1), not rank 1"));
  EXPECT_THAT(message("basis",
                      [](H5Writer& f) {
                        f.matrix<float>("/model/pcaBasis", {1, 9, std::vector<float>(9, 1.0F)});
                      }),
              HasSubstr("has 1 rows and 9 columns instead of 9 and 1"));
  EXPECT_THAT(
      message("variance", [](H5Writer& f) { f.vector<float>("/model/pcaVariance", std::vector<float>{-1}); }),
      HasSubstr("/model/pcaVariance: has a value that is negative"));
  EXPECT_THAT(message("noise", [&](H5Writer& f) { f.scalar("/model/noiseVariance", nan); }),
              HasSubstr("/model/noiseVariance: is negative or not finite"));
  EXPECT_THAT(message("weights",
                      [](H5Writer& f) {
                        f.vector<double>("/foramen/landmarkWeights", std::vector<double>{1, 1});
                      }),
              HasSubstr("/foramen/landmarkWeights: has 2 numbers instead of 3"));
  EXPECT_THAT(message("weights",
                      [](H5Writer& f) {
                        f.vector<double>("/foramen/landmarkWeights", std::vector<double>{1, 0, 1});
                      }),
              HasSubstr("/foramen/landmarkWeights: has a value that is not positive"));
  EXPECT_THAT(message("scores",
                      [](H5Writer& f) {
                        f.matrix<float>("/modelinfo/scores", {2, 2, {1, 1, 1, 1}});
                      }),
              HasSubstr("/modelinfo/scores: has 2 rows"));
}

}  // namespace
}  // namespace foramen
