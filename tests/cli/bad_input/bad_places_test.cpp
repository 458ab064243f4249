// Missing inputs, too few inputs, folders that cannot be read or written, a full disk.
#include <fcntl.h>
#include <sys/file.h>
#include <sys/mount.h>
#include <sys/stat.h>
#include <unistd.h>

#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/bad_input/bad_shapes.hpp"
#include "cli/program.hpp"
#include "support/lopsided_torus.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using testing::Outcome;
using testing::run;
using testing::run_shell;
using testing::TemporaryFolder;

// Three good shapes, made once.
class BadPlaces : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TemporaryFolder;
    const Outcome made =
        run("synth -n 3 --seed 4 --vertices 1500 --quiet -o " + folder_->file("synth").string());
    ASSERT_EQ(made.code, 0) << made.output;
    fs::permissions(folder_->path(), fs::perms::others_all, fs::perm_options::add);
  }
  static void TearDownTestSuite() { delete folder_; }
  static fs::path shapes() { return folder_->file("synth") / "shapes"; }
  static std::string shape(int i) { return (shapes() / ("synth00" + std::to_string(i) + ".ply")).string(); }
  static fs::path scratch(const std::string& name) { return folder_->file(name); }
  static std::string quick(const std::string& inputs, const fs::path& model) {
    return "build --method icp --landmarks 300 --samples 5 --quiet " + inputs + " -o " + model.string();
  }
  static void expect_refused(const std::string& arguments, const std::string& message) {
    SCOPED_TRACE(arguments);
    const Outcome refused = run(arguments);
    EXPECT_EQ(refused.code, 1) << refused.output;
    EXPECT_THAT(refused.output, HasSubstr(message));
    EXPECT_THAT(refused.output, ::testing::Not(HasSubstr("filesystem error"))) << "names no remedy";
  }
  // Runs the command as another user, because root may read everything.
  static std::string as_nobody(const std::string& arguments) {
    const std::string become = geteuid() == 0 ? "setpriv --reuid=65534 --regid=65534 --clear-groups " : "";
    return become + FORAMEN_PROGRAM " " + arguments;
  }
  static bool can_be_nobody() { return run_shell(as_nobody("--version")).code == 0; }

 private:
  static inline TemporaryFolder* folder_ = nullptr;
};

#define FORAMEN_NEEDS_NOBODY() \
  if (!can_be_nobody()) GTEST_SKIP() << "cannot run the program as another user: " << as_nobody("--version")

TEST_F(BadPlaces, InputsThatAreNotThere) {
  const fs::path empty = scratch("empty"), model = scratch("m");
  fs::create_directories(empty);
  fs::create_directories(scratch("notes"));
  std::ofstream(scratch("notes") / "readme.txt") << "no mesh";
  fs::create_directories(scratch("folder.ply"));
  fs::create_symlink("nowhere.ply", scratch("dangling.ply"));
  fs::create_symlink("circle_a.ply", scratch("circle_b.ply"));
  fs::create_symlink("circle_b.ply", scratch("circle_a.ply"));
  const auto given = [&](const fs::path& path) { return quick(path.string(), model); };
  expect_refused(given(empty), "empty: the folder holds no mesh file and no label map (looked for .ply");
  expect_refused(given(scratch("notes")), "notes: the folder holds no mesh file");
  expect_refused(given(scratch("folder.ply")), "folder.ply: the folder holds no mesh file");
  expect_refused(given(scratch("none.ply")), "none.ply: there is no such file or folder");
  expect_refused(given(scratch("none/")), "none/: there is no such file or folder");
  expect_refused(given(scratch("dangling.ply")), "dangling.ply: there is no such file or folder");
  expect_refused(given(scratch("circle_a.ply")), "there is no such file or folder (Too many levels");
  expect_refused(given(std::string(300, 'x')), "there is no such file or folder (File name too long");
  EXPECT_FALSE(fs::exists(model)) << "made for nothing";
  expect_refused("inspect " + scratch("none.ply").string(), "none.ply: no such file");
}

TEST_F(BadPlaces, InputsThatAreNoRegularMeshFiles) {
  std::ofstream(scratch("picture.png")) << "x";
  std::ofstream(scratch("nameless")) << "x";
  ASSERT_EQ(mkfifo(scratch("pipe.ply").c_str(), 0600), 0);
  fs::create_symlink("/dev/zero", scratch("endless.ply"));
  const auto given = [&](const char* name) { return quick(scratch(name).string(), scratch("m")); };
  expect_refused(given("picture.png"), "picture.png: has the unknown extension '.png'");
  expect_refused(given("nameless"), "nameless: has no extension");
  expect_refused(given("pipe.ply"), "pipe.ply: is not a regular file");
  expect_refused(given("endless.ply"), "endless.ply: is not a regular file");
}

TEST_F(BadPlaces, InputsThatAreTooFewOrTheSame) {
  const fs::path twins = scratch("twins"), elsewhere = scratch("elsewhere");
  for (const fs::path& folder : {twins, elsewhere}) fs::create_directories(folder);
  for (const char* name : {"a.ply", "b.ply", "c.ply"}) fs::copy_file(shape(1), twins / name);
  fs::copy_file(shape(1), elsewhere / "synth001.ply");
  std::ofstream(elsewhere / "synth001.stl") << "x";
  const fs::path model = scratch("m");
  expect_refused(quick(shape(1), model), "at least 3 usable shapes, found 1");
  expect_refused(quick(shape(1) + " " + shape(2), model), "at least 3 usable shapes, found 2");
  expect_refused(quick(shape(1) + " " + shape(1) + " " + shape(1), model),
                 "at least 3 usable shapes, found 1");
  expect_refused(quick(twins.string(), model), "found 1");
  expect_refused(quick(twins.string(), model), "left out c.ply: the same surface as a.ply");
  expect_refused(quick(shapes().string() + " " + elsewhere.string(), model),
                 "have the same name without extension");
  expect_refused(quick(shape(1) + " " + (elsewhere / "synth001.ply").string(), model),
                 "elsewhere_synth001.ply");
}

TEST_F(BadPlaces, CopiesInOtherPosesLeaveNothingToModel) {
  const fs::path copies = scratch("copies");
  fs::create_directories(copies);
  for (int i = 0; i < 3; ++i) {
    TriangleSoup soup = testing::lopsided_torus_soup(32, 20);
    for (Vec3& p : soup.points) p.x() += 64 * i;
    std::ofstream(copies / (std::to_string(i) + ".off")) << testing::off_text(soup);
  }
  const fs::path model = scratch("no_variation");
  expect_refused(
      "build --rounds 0 --landmarks 300 --samples 5 --quiet " + copies.string() + " -o " + model.string(),
      "all shapes are the same but for their position");
  EXPECT_FALSE(fs::exists(model / "mean.ply"));
}

TEST_F(BadPlaces, NamesInOptionsThatFitNothing) {
  const std::string all = shapes().string();
  const fs::path model = scratch("m"), truth = scratch("truth");
  fs::create_directories(truth);
  fs::copy_file(shape(1), truth / "synth001.ply");
  expect_refused(quick(all + " --reference nobody", model),
                 "the reference nobody: no usable input has this name");
  expect_refused(quick(all + " --subject-regex '('", model),
                 "the pattern '(' of subjects is not a regular expression");
  expect_refused(quick(all + " --truth " + truth.string(), model),
                 "there is no true correspondence for the shape synth002");
  expect_refused("evaluate " + all + " --shapes " + truth.string(), "has other triangles or another number");
}

TEST_F(BadPlaces, FoldersThatCannotBeMade) {
  std::ofstream(scratch("file")) << "x";
  expect_refused(quick(shapes().string(), scratch("file")), "file: cannot be made a folder");
  expect_refused(quick(shapes().string(), scratch("file") / "m"),
                 "cannot be made a folder (Not a directory)");
  expect_refused(quick(shapes().string(), "/proc/m"), "/proc/m: cannot be made a folder");
  expect_refused(quick(shapes().string(), std::string(300, 'x')),
                 "cannot be made a folder (File name too long)");
  EXPECT_EQ(testing::bytes_of(scratch("file")), "x");
}

TEST_F(BadPlaces, AFolderThatAnotherBuildWritesIn) {
  const fs::path model = scratch("taken");
  fs::create_directories(model);
  const int held = open(model.c_str(), O_RDONLY | O_DIRECTORY);
  ASSERT_EQ(flock(held, LOCK_EX), 0);
  expect_refused(quick(shapes().string(), model), "taken: another build is writing there now");
  close(held);
  EXPECT_EQ(run(quick(shapes().string(), model)).code, 0);
}

TEST_F(BadPlaces, WhatThePermissionsForbid) {
  FORAMEN_NEEDS_NOBODY();
  const fs::path secret = scratch("secret.ply"), closed = scratch("closed"), fixed = scratch("fixed"),
                 open = scratch("open");
  fs::copy_file(shape(1), secret);
  for (const fs::path& folder : {closed, fixed, open}) fs::create_directories(folder);
  fs::copy_file(shape(1), closed / "a.ply");
  fs::permissions(secret, fs::perms::none);
  fs::permissions(closed, fs::perms::none);
  fs::permissions(
      fixed, fs::perms::owner_read | fs::perms::owner_exec | fs::perms::others_read | fs::perms::others_exec);
  fs::permissions(open, fs::perms::all);
  const auto expect_forbidden = [&](const std::string& arguments, const std::string& message) {
    SCOPED_TRACE(arguments);
    const Outcome refused = run_shell(as_nobody(arguments));
    EXPECT_EQ(refused.code, 1) << refused.output;
    EXPECT_THAT(refused.output, HasSubstr(message));
  };
  expect_forbidden(quick(secret.string(), open / "m"), "secret.ply: cannot be opened (Permission denied)");
  expect_forbidden(quick(closed.string(), open / "m"), "closed: cannot read the folder (Permission denied)");
  expect_forbidden(quick((closed / "a.ply").string(), open / "m"),
                   "a.ply: there is no such file or folder (Perm");
  expect_forbidden(quick(shapes().string(), fixed / "m"), "cannot be made a folder (Permission denied)");
  expect_forbidden(quick(shapes().string(), fixed), "fixed: the folder cannot be written to");
  expect_forbidden("inspect " + secret.string(), "secret.ply: cannot be opened (Permission denied)");
  expect_forbidden("sample " + secret.string() + " -o " + (open / "s").string(),
                   "secret.ply: cannot be opened");
  EXPECT_EQ(run_shell(as_nobody(quick(shapes().string(), open / "m"))).code, 0)
      << "where nothing is forbidden";
  fs::permissions(closed, fs::perms::owner_all);
}

// A small disk in memory, which the destructor removes.
class SmallDisk {
 public:
  SmallDisk(fs::path place, int kilobytes) : place_(std::move(place)) {
    fs::create_directories(place_);
    const std::string size = "size=" + std::to_string(kilobytes) + "k";
    mounted_ = mount("tmpfs", place_.c_str(), "tmpfs", 0, size.c_str()) == 0;
  }
  ~SmallDisk() {
    if (mounted_) umount(place_.c_str());
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;
  bool mounted() const { return mounted_; }

 private:
  fs::path place_;
  bool mounted_;
};

TEST_F(BadPlaces, AFullDiskLeavesNothingHalfWritten) {
  const fs::path whole = scratch("whole");
  ASSERT_EQ(run(quick(shapes().string(), whole)).code, 0);
  const auto expected = testing::files_of(whole);
  std::size_t bytes = 0;
  for (const auto& [name, contents] : expected) bytes += contents.size();
  const int all = static_cast<int>(bytes / 1024);
  for (const int kilobytes : {4, all / 8, all / 3, all * 2 / 3, all * 9 / 10}) {
    SCOPED_TRACE(std::to_string(kilobytes) + " of " + std::to_string(all) + " kB");
    const fs::path place = scratch("disk" + std::to_string(kilobytes));
    const SmallDisk disk(place, kilobytes);
    if (!disk.mounted()) GTEST_SKIP() << "cannot mount a small disk (not root, or not allowed to)";
    const Outcome refused = run(quick(shapes().string(), place / "m"));
    EXPECT_EQ(refused.code, 1) << refused.output;
    EXPECT_THAT(refused.output, HasSubstr("No space left on device"));
    EXPECT_THAT(refused.output, HasSubstr("the space on the disk"));
    for (const auto& [name, contents] : testing::files_of(place / "m"))
      EXPECT_TRUE(name.starts_with(".resume/") || contents == expected.at(name))
          << name << " is half-written";
  }
}

}  // namespace
}  // namespace foramen
