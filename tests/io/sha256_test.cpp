#include "io/sha256.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "foramen/core/error.hpp"
#include "support/temporary_folder.hpp"

namespace foramen {
namespace {

// The published examples of FIPS 180-4 and the NIST test vectors.
TEST(Sha256, PublishedVectors) {
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256(std::string(1000000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, CutsDoNotMatter) {
  std::string bytes;
  for (int i = 0; i < 300; ++i) bytes += static_cast<char>(i * 7);
  for (std::size_t length : {55U, 56U, 63U, 64U, 65U, 119U, 128U, 300U})
    for (std::size_t cut = 0; cut <= length; cut += 13) {
      Sha256 hash;
      hash.update(std::string_view(bytes).substr(0, cut));
      const std::string between = hash.hex();
      EXPECT_EQ(between, sha256(std::string_view(bytes).substr(0, cut)));
      EXPECT_EQ(hash.update(std::string_view(bytes).substr(cut, length - cut)).hex(),
                sha256(std::string_view(bytes).substr(0, length)));
    }
}

// Pieces of every length from zero to more than two blocks, so that they begin and end at every place in a
// block.
TEST(Sha256, ManyPieces) {
  std::string bytes;
  for (int i = 0; i < 20000; ++i) bytes += static_cast<char>(i * i % 251);
  for (const std::size_t longest : {1U, 7U, 64U, 150U}) {
    Sha256 hash;
    std::size_t length = 0;
    for (std::string_view rest = bytes; !rest.empty(); rest.remove_prefix(std::min(length, rest.size()))) {
      length = (length + 1) % (longest + 1);
      hash.update(rest.substr(0, length));
    }
    EXPECT_EQ(hash.hex(), sha256(bytes)) << "pieces of up to " << longest << " bytes";
  }
}

TEST(Sha256, OfAFile) {
  const testing::TemporaryFolder folder;
  const std::string bytes(200000, 'x');
  EXPECT_EQ(sha256_of_file(folder.file("a", bytes)), sha256(bytes));
  EXPECT_EQ(sha256_of_file(folder.file("b", "")), sha256(""));
  EXPECT_THROW(sha256_of_file(folder.file("none")), IoError);
  EXPECT_THROW(sha256_of_file(folder.path()), IoError);
}

}  // namespace
}  // namespace foramen
