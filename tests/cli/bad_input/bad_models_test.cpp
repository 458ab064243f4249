// Models and measurements that are damaged or have wrong contents.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/program.hpp"
#include "io/hdf5_file.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;
using testing::bytes_of;
using ::testing::HasSubstr;
using testing::Outcome;
using testing::run;
using testing::TemporaryFolder;

class BadModels : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TemporaryFolder;
    const std::string made = folder_->path().string();
    ASSERT_EQ(run("synth -n 3 --seed 4 --vertices 1500 --quiet -o " + made).code, 0);
    const Outcome built = run("build --method icp --landmarks 300 --samples 5 --quiet " + made +
                              "/shapes -o " + made + "/model");
    ASSERT_EQ(built.code, 0) << built.output;
  }
  static void TearDownTestSuite() { delete folder_; }
  static fs::path good() { return folder_->file("model"); }
  // A copy of the model in which one file has other contents.
  fs::path broken(const std::string& file, const std::string& bytes) const {
    const fs::path copy = scratch_.file("m");
    fs::remove_all(copy);
    fs::copy(good(), copy, fs::copy_options::recursive);
    std::ofstream(copy / file, std::ios::binary | std::ios::trunc) << bytes;
    return copy;
  }
  static std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
  }
  static void expect_refused(const std::string& arguments, const std::string& file,
                             const std::string& message) {
    SCOPED_TRACE(arguments + ": " + message);
    const Outcome refused = run(arguments);
    EXPECT_EQ(refused.code, 1) << refused.output;
    EXPECT_THAT(refused.output, HasSubstr(file + ": "));
    EXPECT_THAT(refused.output, HasSubstr(message));
  }
  void expect_bad_model(const std::string& bytes, const std::string& message) const {
    const fs::path model = broken("model.h5", bytes), out = scratch_.file("out");
    expect_refused("sample " + model.string() + " -o " + out.string(), "model.h5", message);
    expect_refused("modes " + (model / "model.h5").string() + " -o " + out.string(), "model.h5", message);
    EXPECT_FALSE(fs::exists(out) && !fs::is_empty(out)) << "something was written";
  }
  void expect_bad_metrics(const std::string& bytes, const std::string& message) const {
    const fs::path model = broken("metrics.json", bytes);
    expect_refused("compare " + model.string() + " " + good().string(), "metrics.json", message);
  }
  const TemporaryFolder scratch_;

 private:
  static inline TemporaryFolder* folder_ = nullptr;
};

TEST_F(BadModels, ThatAreNoModelFiles) {
  const std::string bytes = bytes_of(good() / "model.h5");
  expect_bad_model("", "is empty");
  expect_bad_model("not a model\n", "is no HDF5 file");
  expect_bad_model(bytes.substr(0, 4), "is no HDF5 file");
  expect_bad_model(bytes.substr(0, bytes.size() / 2), "damaged or cut off");
  expect_bad_model(bytes.substr(0, bytes.size() - 1), "damaged or cut off");
  expect_bad_model(bytes_of(good() / "atlas.h5"), "/version: is missing");
  expect_refused("sample " + scratch_.file("none").string() + " -o x", "none", "there is no such model");
}

TEST_F(BadModels, WhoseContentIsWrong) {
  const auto written = [&](const std::function<void(H5Writer&)>& write) {
    const fs::path file = scratch_.file("made.h5");
    write_h5(file, write);
    return bytes_of(file);
  };
  const auto header = [](H5Writer& file, int major) {
    file.scalar<std::int32_t>("/version/majorVersion", major);
    file.scalar<std::int32_t>("/version/minorVersion", 9);
    file.group("/representer");
    file.attribute("/representer", "datasetType", "POLYGON_MESH");
  };
  const H5Matrix<float> points{3, 4, {0, 1, 0, 0, 0, 0, 2, 0, 0, 0, 0, 3}};
  expect_bad_model(written([&](H5Writer& f) { header(f, 7); }), "/version: is 7.9, not 0.9 or 1.x");
  expect_bad_model(written([&](H5Writer& f) { header(f, 0); }), "/representer/points: is missing");
  expect_bad_model(written([&](H5Writer& f) {
                     header(f, 0);
                     f.matrix("/representer/points", points);
                     f.matrix<std::int32_t>("/representer/cells", {3, 1, {0, 1, 9}});
                   }),
                   "/representer/cells: triangle 0 uses point 9 of 4");
  expect_bad_model(written([&](H5Writer& f) {
                     header(f, 0);
                     f.matrix("/representer/points", points);
                     f.matrix<std::int32_t>("/representer/cells", {3, 1, {0, 1, 2}});
                     f.vector<float>("/model/mean", std::vector<float>{1, 2, 3});
                   }),
                   "/model/mean: has 3 numbers instead of 12");
}

// The file has a few kilobytes and claims to hold sixteen gigabytes of numbers.
TEST_F(BadModels, ThatClaimMoreThanTheyHold) {
  std::string bytes = bytes_of(good() / "model.h5");
  const Outcome usual = run("sample " + good().string() + " -n 1 -o " + scratch_.file("usual").string());
  ASSERT_EQ(usual.code, 0) << usual.output;
  // The length of the mean, 3 x landmarks, in the bytes that HDF5 writes.
  const std::string mesh = bytes_of(good() / "mean.ply");
  const int landmarks = std::stoi(mesh.substr(mesh.find("element vertex ") + 15));
  const auto size = [](std::uint64_t n) {
    std::string text;
    for (int k = 0; k < 8; ++k) text += static_cast<char>(n >> (8 * k) & 0xff);
    return text;
  };
  const std::string length = size(3 * static_cast<std::uint64_t>(landmarks));
  int changed = 0;
  for (auto at = bytes.find(length); at != std::string::npos; at = bytes.find(length, at + 8), ++changed)
    bytes.replace(at, 8, size(std::uint64_t{1} << 32));
  ASSERT_GT(changed, 0);
  const fs::path model = broken("model.h5", bytes);
  const Outcome refused = testing::run_shell(testing::in_three_gigabytes + FORAMEN_PROGRAM " sample " +
                                             model.string() + " -o " + scratch_.file("out").string());
  EXPECT_EQ(refused.code, 1) << refused.output;
  EXPECT_THAT(refused.output, HasSubstr("model.h5: "));
  EXPECT_THAT(refused.output, ::testing::Not(HasSubstr("out of memory")));
}

TEST_F(BadModels, WhoseMetricsAreNone) {
  const std::string json = bytes_of(good() / "metrics.json");
  const std::string why = "is not a metrics file of this version";
  expect_bad_metrics("", why);
  expect_bad_metrics("no json", why);
  expect_bad_metrics(json.substr(0, json.size() / 2), why);
  expect_bad_metrics("[]", why);
  expect_bad_metrics(std::string(100000, '['), why);
  expect_bad_metrics(replaced(json, "\"names\"", "\"nomes\""), why);
  expect_bad_metrics(replaced(json, "\"landmarks\": ", "\"landmarks\": \"many\", \"x\": "), why);
  expect_refused("compare " + scratch_.path().string() + " " + good().string(), "metrics.json",
                 "cannot be read");
}

TEST_F(BadModels, WhoseTableDoesNotBelongToTheMetrics) {
  const std::string csv = bytes_of(good() / "metrics.csv");
  const auto refused = [&](const std::string& bytes, const std::string& message) {
    expect_refused("compare " + broken("metrics.csv", bytes).string() + " " + good().string(), "metrics.csv",
                   message);
  };
  refused("", "");
  refused("item,kind\n", "modes");
  refused(replaced(csv, "synth002,shape,1,generalization_mean_surface", "synth002,shape,1,other"),
          "holds no generalization_mean_surface of synth002 at 1 modes");
  refused(csv.substr(0, csv.size() / 2) + "\n\"open", "");
}

TEST_F(BadModels, WhoseReportCannotBeMade) {
  const auto refused = [&](const std::string& file, const std::string& bytes, const std::string& message) {
    expect_refused("report " + broken(file, bytes).string(), file, message);
  };
  refused("run.json", "no json", "is not JSON");
  refused("run.json", "{}", "version is missing");
  refused("atlas.h5", "no atlas", "is no HDF5 file");
  const std::string atlas = bytes_of(good() / "atlas.h5");
  refused("atlas.h5", atlas.substr(0, atlas.size() / 2), "damaged or cut off");
  refused("atlas.h5", bytes_of(good() / "model.h5"), "/template/points: is missing");
}

}  // namespace
}  // namespace foramen
