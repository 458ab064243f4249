#include "foramen/pipeline/resume_store.hpp"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/temporary_folder.hpp"
#include "support/torus_family.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;
using Start = ResumeStore::Start;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::TemporaryFolder;

fs::path only_entry(const TemporaryFolder& model) {
  const fs::directory_iterator entries(model.file(".resume"));
  EXPECT_EQ(std::distance(begin(entries), end(entries)), 1);
  return *fs::directory_iterator(model.file(".resume"));
}

const std::string bytes("any\0bytes\n", 10);

TEST(ResumeStore, GivesBackWhatWasKeptWhenResumed) {
  const TemporaryFolder model;
  ResumeStore(model.path(), Start::anew).keep("a key", bytes);
  ResumeStore resumed(model.path(), Start::resume);
  EXPECT_EQ(resumed.load("a key"), bytes);
  EXPECT_EQ(resumed.load("another"), std::nullopt);
  EXPECT_EQ(resumed.taken_up(), 1);
  EXPECT_THAT(resumed.notes(), ElementsAre());
  EXPECT_EQ(ResumeStore(model.path(), Start::anew).load("a key"), std::nullopt);
}

TEST(ResumeStore, IsGoneOnceRemoved) {
  const TemporaryFolder model;
  ResumeStore store(model.path(), Start::anew);
  store.keep("a key", bytes);
  store.remove();
  EXPECT_EQ(model.size(), 0);
  store.keep("late", bytes);
  EXPECT_EQ(model.size(), 0);
  EXPECT_THAT(store.notes(), ElementsAre());
}

TEST(ResumeStore, NeverBelievesADamagedEntry) {
  const TemporaryFolder model;
  ResumeStore(model.path(), Start::anew).keep("a key", bytes);
  const fs::path entry = only_entry(model);
  const std::string good = testing::bytes_of(entry);
  std::vector<std::string> damaged;
  for (std::size_t size = 0; size < good.size(); ++size) damaged.push_back(good.substr(0, size));
  for (std::size_t bit = 0; bit < 8 * good.size(); ++bit) {
    damaged.push_back(good);
    damaged.back()[bit / 8] = static_cast<char>(damaged.back()[bit / 8] ^ (1 << bit % 8));
  }
  damaged.push_back(good + "x");
  ResumeStore resumed(model.path(), Start::resume);
  for (const std::string& wrong : damaged) {
    std::ofstream(entry, std::ios::binary | std::ios::trunc) << wrong;
    EXPECT_EQ(resumed.load("a key"), std::nullopt);
  }
  EXPECT_EQ(resumed.taken_up(), 0);
  ASSERT_EQ(resumed.notes().size(), damaged.size());
  EXPECT_THAT(resumed.notes()[0], HasSubstr(entry.string() + ": the finished stage kept there is damaged"));
  resumed.keep("a key", bytes);
  EXPECT_EQ(resumed.load("a key"), bytes);
}

TEST(ResumeStore, AnotherStagesEntryUnderItsNameIsNotTakenForIt) {
  const TemporaryFolder model;
  ResumeStore store(model.path(), Start::anew);
  store.keep("one", bytes);
  const fs::path one = only_entry(model);
  store.keep("two", "other bytes");
  for (const auto& entry : fs::directory_iterator(model.file(".resume")))
    if (entry.path() != one) fs::copy_file(entry, one, fs::copy_options::overwrite_existing);
  EXPECT_EQ(store.load("one"), std::nullopt);
  EXPECT_EQ(store.load("two"), "other bytes");
}

TEST(ResumeStore, WhatAKilledProcessLeftHalfWrittenIsRemoved) {
  const TemporaryFolder model;
  ResumeStore(model.path(), Start::anew).keep("a key", bytes);
  std::ofstream(model.file(".resume") / ".ab12.999-0.foramen-tmp") << "half";
  ResumeStore resumed(model.path(), Start::resume);
  EXPECT_EQ(resumed.load("a key"), bytes);
  only_entry(model);
}

TEST(ResumeStore, GoesOnWithoutKeepingWhereNothingCanBeWritten) {
  const TemporaryFolder model;
  model.file(".resume", "a file in its place");
  ResumeStore store(model.path(), Start::resume);
  store.keep("one", bytes);
  store.keep("two", bytes);
  EXPECT_EQ(store.load("one"), std::nullopt);
  EXPECT_THAT(store.notes(), ElementsAre(HasSubstr("not kept")));
}

TEST(StageScope, NamesEverySurfaceAndOption) {
  const std::vector<Shape> shapes = testing::family();
  const std::string scope = stage_scope(shapes, testing::small());
  EXPECT_EQ(stage_scope(shapes, testing::small()), scope);
  std::vector<std::string> others;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    std::vector<Shape> other = shapes;
    TriangleSoup soup = other[i].mesh.soup();
    soup.points[7].y() = std::nextafter(soup.points[7].y(), 1e9);
    other[i].mesh = build_mesh(soup);
    others.push_back(stage_scope(other, testing::small()));
  }
  std::vector<Shape> swapped = shapes;
  std::swap(swapped[1], swapped[2]);
  others.push_back(stage_scope(swapped, testing::small()));
  BuildOptions options = testing::small();
  options.correspondence.group.lambda = 0.6;
  others.push_back(stage_scope(shapes, options));
  options = testing::small();
  options.correspondence.method = Method::icp;
  others.push_back(stage_scope(shapes, options));
  for (const std::string& other : others) EXPECT_NE(other, scope);
}

}  // namespace
}  // namespace foramen
