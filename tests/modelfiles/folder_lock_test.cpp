#include "modelfiles/folder_lock.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "support/temporary_folder.hpp"

namespace foramen {
namespace {

TEST(FolderLock, IsHeldByOneAtATimeAndLetGoOf) {
  const testing::TemporaryFolder folder, other;
  {
    const FolderLock held(folder.path());
    EXPECT_THAT(
        [&] { FolderLock(folder.path()); },
        ::testing::ThrowsMessage<InvalidInput>(::testing::HasSubstr("another build is writing there")));
    const FolderLock elsewhere(other.path());
  }
  EXPECT_NO_THROW(FolderLock(folder.path()));
  EXPECT_EQ(folder.size(), 0) << "nothing is left in the folder";
}

}  // namespace
}  // namespace foramen
