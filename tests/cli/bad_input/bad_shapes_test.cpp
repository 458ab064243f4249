// A shape that cannot be used is refused if it is the only input, and left out and named in a cohort.
#include <algorithm>
#include <iostream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/bad_input/bad_shapes.hpp"
#include "cli/program.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;
using testing::bad_shapes;
using testing::BadShape;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::Outcome;
using testing::run_shell;
using testing::TemporaryFolder;

class BadShapeAlone : public ::testing::TestWithParam<BadShape> {};

TEST_P(BadShapeAlone, IsRefusedWithTheReasonAndNothingIsWritten) {
  const TemporaryFolder folder;
  const BadShape& bad = GetParam();
  const fs::path file = folder.file(bad.file_name, bad.bytes);
  const Outcome refused =
      run_shell(testing::in_three_gigabytes + FORAMEN_PROGRAM " build --threads 1 --quiet " + file.string() +
                " -o " + folder.file("m").string());
  EXPECT_EQ(refused.code, 1) << refused.output;
  EXPECT_THAT(refused.output, HasSubstr("left out " + bad.file_name + ": "));
  EXPECT_THAT(refused.output, Not(HasSubstr(file.string() + ": "))) << "the file is named once";
  EXPECT_THAT(refused.output, HasSubstr(bad.message));
  EXPECT_EQ(testing::files_of(folder.file("m")).size(), 0u);
}

const auto case_name = [](const auto& info) {
  std::string name = info.param.file_name;
  std::replace(name.begin(), name.end(), '.', '_');
  return name;
};
INSTANTIATE_TEST_SUITE_P(Cli, BadShapeAlone, ::testing::ValuesIn(bad_shapes()), case_name);

TEST(BadShapesInACohort, AreLeftOutByNameAndStrictRefuses) {
  const TemporaryFolder folder;
  const auto made = testing::run("synth -n 3 --seed 4 --vertices 1500 --quiet -o " + folder.path().string());
  ASSERT_EQ(made.code, 0) << made.output;
  const fs::path shapes = folder.file("shapes");
  fs::copy_file(shapes / "synth001.ply", shapes / "synth001_again.ply");
  for (const BadShape& bad : bad_shapes())
    std::ofstream(shapes / bad.file_name, std::ios::binary) << bad.bytes;
  const std::string build = "build --method icp --landmarks 300 --samples 5 " + shapes.string() + " -o " +
                            folder.file("m").string();
  const Outcome lenient = testing::run(build);
  EXPECT_EQ(lenient.code, 0) << lenient.output;
  for (const BadShape& bad : bad_shapes()) {
    const std::string line = "warning: left out " + bad.file_name + ": ";
    const auto at = lenient.output.find(line);
    ASSERT_NE(at, std::string::npos) << line;
    EXPECT_THAT(lenient.output.substr(at, lenient.output.find('\n', at) - at), HasSubstr(bad.message));
  }
  EXPECT_THAT(lenient.output, HasSubstr("left out synth001_again.ply: the same surface as synth001.ply"));
  const std::string record = testing::bytes_of(folder.file("m") / "run.json");
  for (const BadShape& bad : bad_shapes()) EXPECT_THAT(record, HasSubstr("\"" + bad.file_name + "\""));
  std::cout << bad_shapes().size() << " bad shapes beside 3 good ones\n";

  const Outcome strict = testing::run(build + " --strict");
  EXPECT_EQ(strict.code, 1);
}

}  // namespace
}  // namespace foramen
