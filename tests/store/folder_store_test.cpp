#include "foramen/store/folder_store.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/temporary_folder.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;
using Use = FolderStore::Use;
const std::string program = "this program";
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::TemporaryFolder;

fs::path only_entry(const TemporaryFolder& model) {
  const fs::directory_iterator entries(model.file(".resume"));
  EXPECT_EQ(std::distance(begin(entries), end(entries)), 1);
  return *fs::directory_iterator(model.file(".resume"));
}

const std::string bytes("any\0bytes\n", 10);

TEST(FolderStore, GivesBackWhatWasKeptWhenResumed) {
  const TemporaryFolder model;
  FolderStore(model.file(".resume"), program, Use::alone).keep("a key", bytes);
  FolderStore resumed(model.file(".resume"), program, Use::alone);
  EXPECT_EQ(resumed.load("a key"), bytes);
  EXPECT_EQ(resumed.load("another"), std::nullopt);
  EXPECT_EQ(resumed.taken_up(), 1);
  EXPECT_THAT(resumed.notes(), ElementsAre());
}

TEST(FolderStore, IsGoneOnceRemoved) {
  const TemporaryFolder model;
  FolderStore store(model.file(".resume"), program, Use::alone);
  store.keep("a key", bytes);
  store.remove();
  EXPECT_EQ(model.size(), 0);
  store.keep("late", bytes);
  EXPECT_EQ(model.size(), 0);
  EXPECT_THAT(store.notes(), ElementsAre());
}

TEST(FolderStore, NeverBelievesADamagedEntry) {
  const TemporaryFolder model;
  FolderStore(model.file(".resume"), program, Use::alone).keep("a key", bytes);
  const fs::path entry = only_entry(model);
  const std::string good = testing::bytes_of(entry);
  std::vector<std::string> damaged;
  for (std::size_t size = 0; size < good.size(); ++size) damaged.push_back(good.substr(0, size));
  for (std::size_t bit = 0; bit < 8 * good.size(); ++bit) {
    damaged.push_back(good);
    damaged.back()[bit / 8] = static_cast<char>(damaged.back()[bit / 8] ^ (1 << bit % 8));
  }
  damaged.push_back(good + "x");
  FolderStore resumed(model.file(".resume"), program, Use::alone);
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

TEST(FolderStore, AnotherStagesEntryUnderItsNameIsNotTakenForIt) {
  const TemporaryFolder model;
  FolderStore store(model.file(".resume"), program, Use::alone);
  store.keep("one", bytes);
  const fs::path one = only_entry(model);
  store.keep("two", "other bytes");
  for (const auto& entry : fs::directory_iterator(model.file(".resume")))
    if (entry.path() != one) fs::copy_file(entry, one, fs::copy_options::overwrite_existing);
  EXPECT_EQ(store.load("one"), std::nullopt);
  EXPECT_EQ(store.load("two"), "other bytes");
}

TEST(FolderStore, WhatAKilledProcessLeftHalfWrittenIsRemoved) {
  const TemporaryFolder model;
  FolderStore(model.file(".resume"), program, Use::alone).keep("a key", bytes);
  std::ofstream(model.file(".resume") / ".ab12.999-0.foramen-tmp") << "half";
  FolderStore resumed(model.file(".resume"), program, Use::alone);
  EXPECT_EQ(resumed.load("a key"), bytes);
  only_entry(model);
}

TEST(FolderStore, GoesOnWithoutKeepingWhereNothingCanBeWritten) {
  const TemporaryFolder model;
  model.file(".resume", "a file in its place");
  FolderStore store(model.file(".resume"), program, Use::alone);
  store.keep("one", bytes);
  store.keep("two", bytes);
  EXPECT_EQ(store.load("one"), std::nullopt);
  EXPECT_THAT(store.notes(), ElementsAre(HasSubstr("not kept")));
}

TEST(FolderStore, AnotherProgramsEntryIsNotTakenUp) {
  const TemporaryFolder folder;
  FolderStore(folder.path(), "one", Use::alone).keep("a key", bytes);
  EXPECT_EQ(FolderStore(folder.path(), "another", Use::alone).load("a key"), std::nullopt);
}

TEST(FolderStore, ASharedFolderKeepsWhatOthersAreWriting) {
  const TemporaryFolder folder;
  const fs::path half = folder.file(".ab12.999-0.foramen-tmp");
  std::ofstream(half) << "half";
  FolderStore store(folder.path(), program, Use::shared);
  EXPECT_TRUE(fs::exists(half));
  std::vector<std::thread> writers;
  for (int i = 0; i < 4; ++i)
    writers.emplace_back([&] {
      FolderStore other(folder.path(), program, Use::shared);
      for (int k = 0; k < 20; ++k) other.keep("key " + std::to_string(k), bytes);
    });
  for (std::thread& writer : writers) writer.join();
  for (int k = 0; k < 20; ++k) EXPECT_EQ(store.load("key " + std::to_string(k)), bytes);
  EXPECT_THAT(store.notes(), ElementsAre());
}

// Child processes that look for the same results, compute them and keep them, all at once.
TEST(FolderStore, ProcessesThatComputeTheSameAtOnceAllEndWell) {
  const TemporaryFolder folder;
  constexpr int processes = 4, keys = 30;
  std::vector<pid_t> children;
  for (int p = 0; p < processes; ++p) {
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      FolderStore own(folder.path(), program, Use::shared);
      bool all_right = true;
      for (int k = 0; k < keys; ++k) {
        const std::string key = "key " + std::to_string(k), result(10000, static_cast<char>('a' + k % 26));
        if (const auto found = own.load(key)) all_right = all_right && *found == result;
        own.keep(key, result);
        all_right = all_right && own.load(key) == result;
      }
      std::_Exit(all_right && own.notes().empty() ? 0 : 1);
    }
    children.push_back(child);
  }
  for (const pid_t child : children) {
    int status = -1;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_EQ(status, 0);
  }
  EXPECT_EQ(folder.size(), keys) << "nothing half-written is left";
}

}  // namespace
}  // namespace foramen
