#include "io/atomic_file.hpp"

#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <stdexcept>

#include "foramen/core/error.hpp"
#include "support/temporary_folder.hpp"

namespace foramen {
namespace {

using testing::bytes_of;
using testing::TemporaryFolder;

TEST(WriteFile, ReplacesAndLeavesNothingElse) {
  const TemporaryFolder folder;
  const auto path = folder.file("a.json", "old");
  write_file(path, std::string("new\0bytes", 9));
  EXPECT_EQ(bytes_of(path), std::string("new\0bytes", 9));
  EXPECT_EQ(folder.size(), 1);
}

TEST(WriteFile, NothingUnderTheNameUntilDone) {
  const TemporaryFolder folder;
  const auto path = folder.file("a.h5");
  write_file_with(path, [&](const std::filesystem::path& temporary) {
    EXPECT_EQ(temporary.parent_path(), path.parent_path());
    EXPECT_EQ(temporary.extension(), ".h5");
    EXPECT_EQ(temporary.filename().string()[0], '.');
    std::array<char, 300> host{};
    ASSERT_EQ(::gethostname(host.data(), host.size()), 0);
    const std::string writer = std::string(".") + host.data() + "-" + std::to_string(::getpid()) + "-";
    EXPECT_THAT(temporary.filename().string(), ::testing::HasSubstr(writer)) << "others may write the same";
    std::ofstream(temporary) << "half";
    EXPECT_FALSE(std::filesystem::exists(path));
    std::ofstream(temporary) << "whole";
  });
  EXPECT_EQ(bytes_of(path), "whole");
  EXPECT_EQ(folder.size(), 1);
}

TEST(WriteFile, FailureLeavesTheOldFile) {
  const TemporaryFolder folder;
  const auto path = folder.file("a", "old");
  const auto failing = [](const std::filesystem::path& temporary) {
    std::ofstream(temporary) << "half";
    throw std::runtime_error("disk on fire");
  };
  EXPECT_THROW(write_file_with(path, failing), std::runtime_error);
  EXPECT_THROW(write_file_with(path, [](const std::filesystem::path&) {}), IoError);
  EXPECT_EQ(bytes_of(path), "old");
  EXPECT_EQ(folder.size(), 1);
}

TEST(RemoveLeftovers, TakesWhatAKilledWriterLeftAndNothingElse) {
  const TemporaryFolder folder;
  folder.file("kept.json", "whole");
  folder.file(".hidden", "the user's");
  // The temporary file that a killed writer leaves, copied to a folder of its own.
  write_file_with(folder.file("model.h5"), [&](const std::filesystem::path& temporary) {
    std::ofstream(temporary) << "half";
    std::filesystem::create_directory(folder.file("later"));
    std::filesystem::copy_file(temporary, folder.file("later") / temporary.filename());
  });
  remove_leftovers(folder.path());
  EXPECT_EQ(folder.size(), 4) << "nothing here was left over";
  remove_leftovers(folder.file("later"));
  EXPECT_TRUE(std::filesystem::is_empty(folder.file("later")));
  EXPECT_NO_THROW(remove_leftovers(folder.file("no such folder")));
}

TEST(WriteFile, RefusesPlacesThatCannotBeReplaced) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.file("folder"));
  EXPECT_THROW(write_file(folder.file("folder"), "x"), IoError);
  EXPECT_THROW(write_file("/dev/null", "x"), IoError);
  try {
    write_file(folder.file("none") / "a", "x");
    FAIL();
  } catch (const IoError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("its folder does not exist; create it first"));
  }
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

}  // namespace
}  // namespace foramen
