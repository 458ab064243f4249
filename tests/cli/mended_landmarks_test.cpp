// Surfaces thinner than the spacing of landmarks: what a build reports about self-intersecting corresponding
// meshes.
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/program.hpp"
#include "foramen/io/mesh_file.hpp"
#include "support/lopsided_torus.hpp"
#include "support/temporary_folder.hpp"

namespace foramen {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using testing::Outcome;
using testing::run;

struct Mended {
  std::string output;
  int before, not_mended;  // numbers of pairs of triangles in run.json
};

Mended build_of_walls(double half_wall_mm, double width) {
  const testing::TemporaryFolder folder;
  for (int i = 0; i < 3; ++i)
    write_ply(folder.path() / ("wall" + std::to_string(i) + ".ply"),
              testing::walled_torus_soup(60, 30, 0.8 + 0.15 * i, half_wall_mm, width));
  const auto model = folder.path() / "model";
  const Outcome built =
      run("build --landmarks 300 --samples 2 --rounds 1 " + folder.path().string() + " -o " + model.string());
  EXPECT_EQ(built.code, 0) << built.output;
  const auto record = nlohmann::json::parse(testing::bytes_of(model / "run.json"));
  return {built.output, record.at("self_intersections_before_mending"),
          record.at("self_intersections_not_mended")};
}

std::string pairs_line(int sampled, int before) {
  return "self-intersecting pairs of triangles: " + std::to_string(sampled) + " in the sampled meshes, " +
         std::to_string(before) + " before they were mended, 0 in the inputs";
}

TEST(MendedLandmarks, AThinWallIsPartedAndSaidToHaveMet) {
  const Mended mended = build_of_walls(0.04, 0.3);
  EXPECT_GT(mended.before, 0);
  EXPECT_EQ(mended.not_mended, 0);
  EXPECT_THAT(mended.output, HasSubstr(pairs_line(0, mended.before)));
  EXPECT_THAT(mended.output, Not(HasSubstr("warning")));
}

TEST(MendedLandmarks, WhatCouldNotBePartedIsWarnedOf) {
  const Mended mended = build_of_walls(0.005, 0.6);
  EXPECT_GT(mended.not_mended, 0);
  EXPECT_LT(mended.not_mended, mended.before);
  EXPECT_THAT(mended.output, HasSubstr(pairs_line(mended.not_mended, mended.before)));
  EXPECT_THAT(mended.output, HasSubstr("warning: " + std::to_string(mended.not_mended) +
                                       " pairs of landmark triangles meet"));
}

}  // namespace
}  // namespace foramen
