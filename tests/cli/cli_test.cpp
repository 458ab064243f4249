// The program as a user runs it: exit codes, messages, files.

#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/program.hpp"
#include "foramen/io/mesh_file.hpp"
#include "io/sha256.hpp"
#include "support/handles.hpp"
#include "support/label_maps.hpp"
#include "support/meshes.hpp"
#include "support/real_data.hpp"
#include "support/temporary_folder.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;
using testing::bytes_of;
using testing::files_of;
using ::testing::HasSubstr;
using testing::Outcome;
using testing::run;

// A small synthetic cohort, made once for all tests.
class Cli : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new testing::TemporaryFolder;
    const Outcome made = run("synth -n 4 --seed 7 --vertices 2500 -o " + synth().string());
    ASSERT_EQ(made.code, 0) << made.output;
  }
  static void TearDownTestSuite() { delete folder_; }
  static fs::path folder() { return folder_->path(); }
  static fs::path synth() { return folder() / "synth"; }
  static std::string small_build(const std::string& more) {
    return "build --landmarks 400 --samples 30 --quiet " + more + " ";
  }

 private:
  static inline testing::TemporaryFolder* folder_ = nullptr;
};

TEST_F(Cli, UsageErrorsExitWith2) {
  EXPECT_EQ(run("").code, 2);
  EXPECT_EQ(run("frobnicate").code, 2);
  EXPECT_EQ(run("build").code, 2);
  EXPECT_EQ(run("build x -o y --method magic").code, 2);
  EXPECT_EQ(run("build x -o y --landmarks 400 --target-error 1").code, 2);
  EXPECT_EQ(run("build x -o y --objective beauty").code, 2);
  EXPECT_EQ(run("build x -o y --rounds -1").code, 2);
  EXPECT_EQ(run("synth -o y --vertices 1499").code, 2) << "fewer are refused by the library";
  EXPECT_EQ(run("--help").code, 0);
  EXPECT_THAT(run("--version").output, HasSubstr("foramen "));
}

TEST_F(Cli, WhatIsNotThereIsNamed) {
  const Outcome missing = run("build /no/such/folder -o " + (folder() / "m").string());
  EXPECT_EQ(missing.code, 1);
  EXPECT_THAT(missing.output, HasSubstr("/no/such/folder"));
  EXPECT_EQ(run("compare /no/a /no/b").code, 1);
  EXPECT_EQ(run("sample /no/model -o " + (folder() / "s").string()).code, 1);
}

TEST_F(Cli, InspectGivesAVerdictAFile) {
  const fs::path file = *fs::directory_iterator(synth() / "shapes");
  const Outcome good = run("inspect --json " + file.string());
  EXPECT_EQ(good.code, 0);
  const auto report = nlohmann::json::parse(good.output).at("files").at(0);
  EXPECT_EQ(report.at("genus"), 1);
  EXPECT_EQ(report.at("usable"), true);

  TriangleSoup open = testing::torus_soup(12, 9);
  open.triangles.pop_back();
  const fs::path broken = folder() / "open.ply";
  write_ply(broken, open);
  const Outcome refused = run("inspect " + broken.string());
  EXPECT_EQ(refused.code, 1);
  EXPECT_THAT(refused.output, HasSubstr("NOT USABLE"));
}

TEST_F(Cli, ARefitIsReportedInEveryFile) {
  const fs::path model = folder() / "refit";
  const Outcome built = run("build --method icp --refit --landmarks 400 --samples 5 " +
                            (synth() / "shapes").string() + " -o " + model.string());
  ASSERT_EQ(built.code, 0) << built.output;
  EXPECT_THAT(built.output, HasSubstr("4 of 4 shapes entered"));
  const auto metrics = nlohmann::json::parse(bytes_of(model / "metrics.json"));
  EXPECT_EQ(metrics.at("refit").at("names").size(), 4u);
  EXPECT_EQ(metrics.at("refit").at("by_modes").size(), 2u);
  EXPECT_THAT(bytes_of(model / "metrics.csv"), HasSubstr("refit_mean_surface"));
  EXPECT_THAT(bytes_of(model / "report.html"), HasSubstr("refit, leave one shape out"));
  const auto record = nlohmann::json::parse(bytes_of(model / "run.json"));
  EXPECT_THAT(record.at("command").get<std::string>(), HasSubstr("--refit"));
  EXPECT_EQ(run("compare " + model.string() + " " + model.string()).code, 0);
}

TEST_F(Cli, AreaWeightsAreTakenAndRecorded) {
  const fs::path model = folder() / "area", metrics = folder() / "area_metrics";
  const std::string shapes = (synth() / "shapes").string();
  const Outcome built =
      run("build --landmarks 400 --samples 5 --weights AREA " + shapes + " -o " + model.string());
  ASSERT_EQ(built.code, 0) << built.output;
  EXPECT_THAT(built.output, HasSubstr("landmark weights: area"));
  const auto record = nlohmann::json::parse(bytes_of(model / "run.json"));
  EXPECT_EQ(record.at("options").at("landmark_weights"), "area");
  EXPECT_THAT(record.at("command").get<std::string>(), HasSubstr("--weights area"));
  EXPECT_EQ(run("sample " + model.string() + " -n 2 -o " + (folder() / "area_samples").string()).code, 0);

  const std::string evaluate = "evaluate --samples 5 --shapes " + shapes + " -o " + metrics.string() + " ";
  const auto of = [](const fs::path& where) {
    return nlohmann::json::parse(bytes_of(where / "metrics.json"));
  };
  ASSERT_EQ(run(evaluate + "--weights area " + model.string()).code, 0);
  EXPECT_NEAR(of(metrics).at("total_variance_mm2"), of(model).at("total_variance_mm2"), 1e-4)
      << "meshes are files of single precision";
  EXPECT_EQ(of(metrics).at("options").at("landmark_weights"), "area");
  const Outcome equal = run(evaluate + model.string());
  ASSERT_EQ(equal.code, 0);
  EXPECT_THAT(equal.output, HasSubstr("weights: equal"));
  EXPECT_EQ(of(metrics).at("options").at("landmark_weights"), "equal");
  EXPECT_NE(of(metrics).at("total_variance_mm2"), of(model).at("total_variance_mm2"));
  EXPECT_THAT(
      run("compare " + model.string() + " " + metrics.string() + " -o " + (folder() / "c").string()).output,
      HasSubstr("weights"));
  EXPECT_EQ(run(evaluate + "--weights heavy " + model.string()).code, 2);
}

TEST_F(Cli, PartsOfTheRegistrationAreChosenAndRecorded) {
  const fs::path model = folder() / "parts";
  const std::string shapes = (synth() / "shapes").string();
  const auto built = [&](const std::string& parts) {
    const Outcome outcome =
        run("build --landmarks 400 --samples 5 " + parts + " " + shapes + " -o " + model.string());
    EXPECT_EQ(outcome.code, 0) << outcome.output;
    return nlohmann::json::parse(bytes_of(model / "run.json"));
  };
  const auto rigid = built("--rounds 0 --distortion plane --bending rigid --lambda 0.2");
  const auto& options = rigid.at("options");
  EXPECT_EQ(options.at("objective"), "surface");
  EXPECT_EQ(options.at("lambda"), 0.2);
  EXPECT_EQ(options.at("group").at("rounds"), 0);
  EXPECT_EQ(options.at("group").at("distortion"), "plane");
  EXPECT_EQ(options.at("group").at("bending"), "rigid");
  EXPECT_EQ(rigid.at("template_motion_mm").size(), 0u);
  EXPECT_THAT(rigid.at("command").get<std::string>(),
              HasSubstr("--rounds 0 --distortion plane --bending rigid"));

  const auto described = built("--objective description --rounds 0");
  EXPECT_EQ(described.at("options").at("objective"), "description");
  EXPECT_EQ(described.at("options").at("group").at("bending"), "cohort");
  EXPECT_EQ(described.at("description_lengths").size(), 4u) << "before each of three rounds and at the end";

  const auto neighbours = built("--objective neighbours");
  EXPECT_EQ(neighbours.at("options").at("objective"), "neighbours");
  EXPECT_FALSE(neighbours.at("options").contains("group"));
  EXPECT_NE(neighbours.at("options").at("lambda"), described.at("options").at("lambda"));
}

TEST_F(Cli, PartsOfNoEffectAreRefused) {
  for (const std::string other : {"--method icp", "--objective neighbours", "--paper"})
    for (const std::string part : {"--rounds 1", "--distortion plane", "--bending rigid"}) {
      const Outcome refused = run("build x -o y " + other + " " + part);
      EXPECT_EQ(refused.code, 2);
      EXPECT_THAT(refused.output, HasSubstr(part.substr(0, part.find(' '))));
    }
}

TEST_F(Cli, ABadShapeIsLeftOutAndNamedAndStrictRefuses) {
  const fs::path mixed = folder() / "mixed";
  fs::create_directories(mixed);
  fs::copy(synth() / "shapes", mixed);
  TriangleSoup open = testing::torus_soup(12, 9);
  open.triangles.pop_back();
  write_ply(mixed / "open.ply", open);
  std::ofstream(mixed / "empty.ply");
  const std::string arguments =
      "build --landmarks 400 --samples 5 " + mixed.string() + " -o " + (folder() / "m").string();
  const Outcome lenient = run(arguments);
  EXPECT_EQ(lenient.code, 0) << lenient.output;
  EXPECT_THAT(lenient.output, HasSubstr("left out open.ply"));
  EXPECT_THAT(lenient.output, HasSubstr("left out empty.ply"));
  EXPECT_EQ(run(arguments + " --strict").code, 1);
}

// A surface of genus 2 that can be repaired: a torus with a bridge.
TriangleSoup bridged() {
  testing::TorusWithHandles torus(120, 60);
  torus.bridge(10, 20, 14);
  torus.shake(0.01, 1);
  return torus.soup;
}

TEST_F(Cli, RepairWritesWhatItMendedAndListsIt) {
  const fs::path raw = folder() / "bridged.ply", out = folder() / "mended.ply";
  write_ply(raw, bridged(), AnatomicalSpace::ras);
  const Outcome inspected = run("inspect " + raw.string());
  EXPECT_EQ(inspected.code, 1);
  EXPECT_THAT(inspected.output, HasSubstr("beside the canal: bridge"));
  EXPECT_THAT(inspected.output, HasSubstr("(run `foramen repair`, or build with --repair)"));

  const Outcome mended = run("repair " + raw.string() + " -o " + out.string());
  EXPECT_EQ(mended.code, 0) << mended.output;
  EXPECT_THAT(mended.output, HasSubstr("cut a bridge"));
  EXPECT_EQ(read_mesh(out).space, AnatomicalSpace::ras);
  EXPECT_EQ(run("inspect --quiet " + out.string()).code, 0);

  const auto report =
      nlohmann::json::parse(run("repair --json " + raw.string() + " -o " + out.string()).output);
  EXPECT_EQ(report.at("changes").at(0).at("change"), "bridges cut");
  const TriangleSoup before = read_mesh(raw).soup, after = read_mesh(out).soup;
  ASSERT_EQ(report.at("origin").size(), after.points.size());
  for (std::size_t v = 0; v < after.points.size(); ++v)
    if (const int was = report.at("origin").at(v); was >= 0) {
      EXPECT_EQ(after.points[v], before.points[was]);
    }

  const Outcome again = run("repair " + out.string() + " -o " + (folder() / "again.ply").string());
  EXPECT_THAT(again.output, HasSubstr("nothing to mend"));
  EXPECT_EQ(bytes_of(folder() / "again.ply"), bytes_of(out));
}

TEST_F(Cli, RepairRefusesAndLeavesNoFile) {
  const fs::path sphere = folder() / "sphere.ply", out = folder() / "none.ply";
  write_ply(sphere,
            {{{20, 0, 0}, {-20, 0, 0}, {0, 20, 0}, {0, -20, 0}, {0, 0, 20}, {0, 0, -20}},
             {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}});
  const Outcome refused = run("repair " + sphere.string() + " -o " + out.string());
  EXPECT_EQ(refused.code, 1);
  EXPECT_THAT(refused.output, HasSubstr("sphere.ply: genus 0"));
  EXPECT_THAT(refused.output, HasSubstr("arch is open"));
  EXPECT_FALSE(fs::exists(out));
  EXPECT_THAT(run("repair " + sphere.string() + " -o " + (folder() / "out.xyz").string()).output,
              HasSubstr(".ply or .vtp"));
  EXPECT_EQ(run("repair " + sphere.string()).code, 2);
  EXPECT_EQ(run("build x -o y --handle-limit 20").code, 2) << "of no effect without --repair";
}

TEST_F(Cli, BuildRepairsWhatItWouldLeaveOutAndSaysSo) {
  const fs::path mixed = folder() / "to_repair", model = folder() / "repaired";
  fs::create_directories(mixed);
  fs::copy(synth() / "shapes", mixed);
  TriangleSoup holed = read_mesh(mixed / "synth001.ply").soup;
  holed.triangles.resize(holed.triangles.size() - 1);
  write_ply(mixed / "synth001.ply", holed);
  const std::string arguments =
      "build --method icp --landmarks 400 --samples 5 " + mixed.string() + " -o " + model.string();
  EXPECT_THAT(run(arguments).output, HasSubstr("left out synth001.ply"));
  const Outcome repaired = run(arguments + " --repair --strict");
  EXPECT_EQ(repaired.code, 0) << repaired.output;
  EXPECT_THAT(repaired.output, HasSubstr("synth001.ply: repaired: holes filled: 1 at ("));
  const auto record = nlohmann::json::parse(bytes_of(model / "run.json"));
  EXPECT_EQ(record.at("shapes").at(0).at("repair").at("changes").at(0).at("change"), "holes filled");
  EXPECT_THAT(record.at("command").get<std::string>(), HasSubstr("--repair"));
  EXPECT_THAT(bytes_of(model / "report.html"), HasSubstr("measured to the repaired surface"));
}

TEST_F(Cli, FewerThanThreeShapesAreRefused) {
  const std::string shapes = (synth() / "shapes").string();
  const Outcome two =
      run(small_build(shapes + "/synth001.ply " + shapes + "/synth002.ply -o " + (folder() / "m2").string()));
  EXPECT_EQ(two.code, 1);
  EXPECT_THAT(two.output, HasSubstr("at least 3"));
}

TEST_F(Cli, WrongUnitsAreRefusedWithTheLikelyOne) {
  const fs::path metres = folder() / "metres";
  fs::create_directories(metres);
  for (const auto& entry : fs::directory_iterator(synth() / "shapes")) {
    TriangleSoup soup = read_mesh(entry.path()).soup;
    for (Vec3& p : soup.points) p /= 1000;
    write_ply(metres / entry.path().filename(), soup);
  }
  const Outcome refused = run(small_build(metres.string() + " -o " + (folder() / "m3").string()));
  EXPECT_EQ(refused.code, 1);
  EXPECT_THAT(refused.output, HasSubstr("(--units m)"));
}

// Four asymmetric tori of different size beside each other, as labels 20 to 23.
fs::path spine(const fs::path& folder) {
  const auto label_at = [](const Vec3& p) {
    for (int n = 0; n < 4; ++n)
      if (testing::bumpy_torus(p - Vec3(54 * n - 81, 0, 0), 15 + 0.5 * n, 5 + 0.3 * n) < 0) return 20 + n;
    return 0;
  };
  const LabelMap map = testing::labelled_lattice({108, 28, 12}, Vec3(2, 2, 2).asDiagonal(), label_at);
  std::ofstream(folder / "spine.nii.gz", std::ios::binary) << testing::packed(testing::nifti_bytes(map));
  return folder / "spine.nii.gz";
}

TEST_F(Cli, ExtractGivesMeshesOfLabels) {
  const std::string map = spine(folder()).string(), out = (folder() / "extracted").string();
  const Outcome extracted = run("extract " + map + " --labels 20-22,23,24-26 -o " + out);
  EXPECT_EQ(extracted.code, 0) << extracted.output;
  EXPECT_THAT(extracted.output, HasSubstr("spine_L4: "));
  EXPECT_THAT(extracted.output, HasSubstr("has no labels 24-26"));
  EXPECT_EQ(run("inspect " + out + "/spine_L1.ply").code, 0);
  EXPECT_EQ(run("extract " + map + " --labels 20,3 -o " + out + "2").code, 1);
  EXPECT_FALSE(fs::exists(out + "2"));
  EXPECT_EQ(run("extract " + map + " --labels 24-20 -o " + out).code, 2);
  EXPECT_EQ(run("extract " + map + " --numbering other -o " + out).code, 2);
  const Outcome other = run("extract " + map + " --numbering totalsegmentator --json -o " + out + "3");
  EXPECT_EQ(other.code, 1) << "labels 20 to 23 are no vertebrae there";
  EXPECT_THAT(other.output, HasSubstr("(--labels; --numbering or --label-names)"));
  std::ofstream(folder() / "names.csv") << "label,name\n21,second\n";
  const Outcome named = run("extract " + map + " --quiet --label-names " + (folder() / "names.csv").string() +
                            " -o " + out + "4");
  EXPECT_EQ(named.code, 0) << named.output;
  EXPECT_TRUE(fs::exists(out + "4/spine_second.ply"));
  const auto record = nlohmann::json::parse(bytes_of(out + "4/extract.json"));
  EXPECT_EQ(record.at("command"), "foramen extract spine.nii.gz --label-names names.csv");
}

TEST_F(Cli, BuildTakesLabelMapsAndSaysSo) {
  const std::string map = spine(folder()).string();
  const fs::path one = folder() / "labels1", two = folder() / "labels2";
  const std::string build = "build --method icp --landmarks 400 --samples 5 --labels 20-24 " + map + " -o ";
  const Outcome built = run(build + one.string() + " --threads 1");
  ASSERT_EQ(built.code, 0) << built.output;
  EXPECT_THAT(built.output, HasSubstr("has no label 24"));
  ASSERT_EQ(run(build + two.string() + " --threads 2 --quiet").code, 0);
  EXPECT_TRUE(files_of(one) == files_of(two));
  const auto record = nlohmann::json::parse(bytes_of(one / "run.json"));
  EXPECT_EQ(record.at("command"),
            "foramen build spine.nii.gz --method icp --landmarks 400 --samples 5 --labels 20-24");
  EXPECT_EQ(record.at("options").at("label_maps").at("labels"), "20-24");
  ASSERT_EQ(record.at("inputs").size(), 4u);
  EXPECT_EQ(record.at("inputs").at(1).at("file"), "spine.nii.gz");
  EXPECT_EQ(record.at("inputs").at(1).at("label"), 21);
  EXPECT_EQ(record.at("inputs").at(1).at("sha256"), sha256_of_file(map));
  EXPECT_EQ(record.at("shapes").at(1).at("name"), "spine_L2");
  // The mesh has the coordinates of the label map.
  const MeshFile corresponding = read_mesh(one / "corresponding" / "spine_L2.ply");
  for (const Vec3& p : corresponding.soup.points) EXPECT_LT((p - Vec3(-27, 0, 0)).norm(), 30);
  const Outcome meshes =
      run("build --labels 20 " + (synth() / "shapes").string() + " -o " + (folder() / "m").string());
  EXPECT_EQ(meshes.code, 1);
  EXPECT_THAT(meshes.output, HasSubstr("no label map among the inputs"));
}

}  // namespace
}  // namespace foramen
