// Surfaces in another unit than mm, at every command that takes surfaces without a model.
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/program.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/io/mesh_file.hpp"
#include "support/temporary_folder.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::Outcome;
using testing::run;

// Synthetic shapes with their true correspondence in shapes/ and truth/, and both in metres in m/.
class Units : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new testing::TemporaryFolder;
    ASSERT_EQ(run("synth -n 4 --seed 5 --vertices 1500 --quiet -o " + at("")).code, 0);
    for (const char* name : {"shapes", "truth"}) {
      fs::create_directories(at("m/") + name);
      for (const auto& entry : fs::directory_iterator(at(name))) {
        TriangleSoup soup = read_mesh(entry.path()).soup;
        for (Vec3& p : soup.points) p /= 1000;
        write_ply(fs::path(at("m/")) / name / entry.path().filename(), soup);
      }
    }
  }
  static void TearDownTestSuite() { delete folder_; }
  static std::string at(const std::string& name) { return (folder_->path() / name).string(); }

  // Refused without a unit, and taken silently in metres.
  static void expect_metres_only(const std::string& command) {
    SCOPED_TRACE(command);
    const Outcome refused = run(command);
    EXPECT_EQ(refused.code, 1) << refused.output;
    EXPECT_THAT(refused.output, HasSubstr("probably in m, give this unit (--units m)"));
    const Outcome metres = run(command + " --units m");
    EXPECT_EQ(metres.code, 0) << metres.output;
    EXPECT_THAT(metres.output, Not(HasSubstr("warning: ")));
  }
  // Taken with a warning if mm is given.
  static void expect_taken_if_certain(const std::string& command) {
    const Outcome certain = run(command + " --units mm");
    EXPECT_EQ(certain.code, 0) << certain.output;
    EXPECT_THAT(certain.output, HasSubstr("warning: "));
    EXPECT_THAT(certain.output, HasSubstr("; a vertebra has 20 to 250 mm"));
  }

 private:
  static inline testing::TemporaryFolder* folder_ = nullptr;
};

TEST_F(Units, AreCheckedByEveryCommand) {
  for (const std::string& command :
       {"evaluate --samples 2 " + at("m/truth"), "convert " + at("m/truth") + " -o " + at("m.tps")}) {
    expect_metres_only(command);
    expect_taken_if_certain(command);
  }
  expect_metres_only("repair " + at("m/shapes/synth001.ply") + " -o " + at("m.ply"));
}

TEST_F(Units, OfAnEvaluationAreThoseOfAllItsFolders) {
  const auto measures = [&](const std::string& folder, const std::string& more) {
    const Outcome evaluated = run("evaluate --json --samples 2 " + at(folder + "truth") + " --shapes " +
                                  at(folder + "shapes") + " --truth " + at(folder + "truth") + more);
    EXPECT_EQ(evaluated.code, 0) << evaluated.output;
    const auto json = nlohmann::json::parse(evaluated.output);
    return std::pair(json.at("representation").at("mean_mm").at("mean").get<double>(),
                     json.at("truth").at("error").at("mean").get<double>());
  };
  const auto mm = measures("", ""), metres = measures("m/", " --units m");
  EXPECT_NEAR(metres.first, mm.first, 1e-3);
  EXPECT_NEAR(metres.second, mm.second, 1e-3);
  const std::string mixed = "evaluate --samples 2 " + at("truth");
  for (const char* option : {" --shapes ", " --truth "}) {
    const std::string folder = option == std::string(" --truth ") ? "m/truth" : "m/shapes";
    const Outcome refused = run(mixed + option + at(folder));
    EXPECT_EQ(refused.code, 1) << refused.output;
    EXPECT_THAT(refused.output, HasSubstr(folder));
    EXPECT_THAT(refused.output, HasSubstr("(--units m)"));
  }
  ASSERT_EQ(run("evaluate --quiet --samples 2 --units m " + at("m/truth") + " --truth " + at("m/truth") +
                " --true-landmarks " + at("landmarks"))
                .code,
            0);
  EXPECT_LT(bounding_box(read_mesh(at("landmarks/synth001.ply")).soup.points).diagonal(), 1)
      << "what is written has the unit of what is read";
}

TEST_F(Units, AreSaidByInspect) {
  const std::string inspect = "inspect " + at("m/shapes/synth001.ply");
  EXPECT_THAT(run(inspect).output, HasSubstr("(not mm; probably m)"));
  EXPECT_THAT(run(inspect + " --units m").output, HasSubstr(" (mm), area"));
  EXPECT_THAT(run(inspect + " --units mm").output, HasSubstr("(mm; the size of no vertebra), area"));
  EXPECT_THAT(run("inspect --units m " + at("shapes/synth001.ply")).output,
              HasSubstr("the file is not in m)"));
}

}  // namespace
}  // namespace foramen
