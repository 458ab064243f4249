// Inputs of another kind than a command takes, and values of another kind than an option takes.
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/program.hpp"
#include "foramen/io/mesh_file.hpp"
#include "support/meshes.hpp"
#include "support/temporary_folder.hpp"

namespace foramen {
namespace {

using ::testing::HasSubstr;
using testing::Outcome;
using testing::run;
using testing::TemporaryFolder;

void expect_refused(const std::string& command, const std::string& said) {
  const Outcome refused = run(command);
  EXPECT_EQ(refused.code, 1) << command << '\n' << refused.output;
  EXPECT_THAT(refused.output, HasSubstr(said)) << command;
}

TEST(WrongKinds, ALabelMapIsToBeExtracted) {
  const TemporaryFolder folder;
  const std::string map = folder.file("spine.nii.gz", "voxels").string(),
                    out = folder.file("out.ply").string();
  for (const std::string& command : {"inspect " + map, "repair " + map + " -o " + out, "evaluate " + map,
                                     "evaluate " + folder.path().string()})
    expect_refused(command, "(run `foramen extract` first)");
}

TEST(WrongKinds, AFolderIsNoMesh) {
  const TemporaryFolder folder;
  const std::string out = folder.file("out.ply").string();
  expect_refused("inspect " + folder.path().string(), "is a folder; name a mesh file in it");
  expect_refused("repair " + folder.path().string() + " -o " + out, "is a folder; name a mesh file in it");
}

TEST(WrongKinds, AFileIsNoPlaceForAFolder) {
  const TemporaryFolder folder, meshes;
  const std::string taken = folder.file("taken", "").string();
  for (const char* name : {"a.ply", "b.ply", "c.ply"})
    write_ply(meshes.file(name), testing::torus_soup(8, 6));
  expect_refused("convert " + meshes.path().string() + " --to ply -o " + taken,
                 "taken: cannot be made a folder");
  expect_refused("synth -n 1 -o " + taken, "taken/shapes: cannot be made a folder");
}

TEST(WrongKinds, AValueThatIsNoNumberIsToldSo) {
  const std::string build = "build shapes -o out ";
  for (const auto& [option, said] :
       {std::pair{"--landmarks many", "the value many is not a whole number in [50, 200000]"},
        {"--landmarks 100.5", "the value 100.5 is not a whole number in"},
        {"--seed -1", "the value -1 is not a whole number of 0 or more"},
        {"--lambda x", "the value x is not a number > 0"}}) {
    const Outcome refused = run(build + option);
    EXPECT_EQ(refused.code, 2) << option;
    EXPECT_THAT(refused.output, HasSubstr(said));
  }
}

TEST(WrongKinds, AnUnknownCommandIsNamed) {
  const Outcome refused = run("projekt model");
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.output, HasSubstr("there is no command projekt"));
  EXPECT_THAT(run("").output, HasSubstr("A subcommand is required"));
}

}  // namespace
}  // namespace foramen
