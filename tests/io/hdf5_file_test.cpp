#include "io/hdf5_file.hpp"

#include <csignal>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <limits>
#include <thread>

#include "foramen/core/error.hpp"
#include "foramen/core/rng.hpp"
#include "support/temporary_folder.hpp"

namespace foramen {
namespace {

using testing::bytes_of;
using ::testing::HasSubstr;
using testing::TemporaryFolder;

void write_everything(H5Writer& file) {
  file.scalar("/numbers/f64", 0.1);
  file.scalar("/numbers/f32", 0.1F);
  file.scalar<std::int32_t>("/numbers/i32", -7);
  file.vector<double>("/deep/er/doubles", std::vector<double>{1, -2, 1e300});
  file.vector<std::int32_t>("/none", std::vector<std::int32_t>{});
  file.matrix<std::int32_t>("/cells", {2, 3, {1, 2, 3, 4, 5, 6}});
  file.matrix<float>("/thin", {3, 1, {1, 2, 3}});
  file.string("/text", "hello");
  file.string("/empty", "");
  file.string("/name", "Wirbelk\xC3\xB6rper");
  file.strings("/names", std::vector<std::string>{"a", "", "long one"});
  file.group("/group");
  file.attribute("/group", "kind", "POLYGON_MESH");
}

// The message of the IoError that the work must throw. HDF5 itself must print nothing.
template <class Work>
std::string message(const Work& work) {
  ::testing::internal::CaptureStderr();
  std::string text = "nothing was thrown";
  try {
    work();
  } catch (const IoError& error) {
    text = error.what();
  }
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "") << "HDF5 printed";
  return text;
}

TEST(H5File, RoundTripOfEverything) {
  const TemporaryFolder folder;
  write_h5(folder.file("a.h5"), write_everything);
  EXPECT_EQ(folder.size(), 1);
  const H5Reader file(folder.file("a.h5"));
  EXPECT_EQ(file.scalar<double>("/numbers/f64"), 0.1);
  EXPECT_EQ(file.scalar<float>("/numbers/f32"), 0.1F);
  EXPECT_EQ(file.scalar<std::int32_t>("/numbers/i32"), -7);
  EXPECT_EQ(file.scalar<double>("/numbers/i32"), -7);
  EXPECT_EQ(file.vector<double>("/deep/er/doubles"), (std::vector<double>{1, -2, 1e300}));
  EXPECT_TRUE(file.vector<std::int32_t>("/none").empty());
  EXPECT_EQ(file.matrix<std::int32_t>("/cells").values, (std::vector<std::int32_t>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(file.shape("/cells"), (std::vector<std::size_t>{2, 3}));
  EXPECT_EQ(file.matrix<float>("/thin").rows, 3U);
  EXPECT_TRUE(file.shape("/text").empty());
  EXPECT_EQ(file.string("/text"), "hello");
  EXPECT_EQ(file.string("/empty"), "");
  EXPECT_EQ(file.string("/name"), "Wirbelk\xC3\xB6rper");
  EXPECT_EQ(file.strings("/names"), (std::vector<std::string>{"a", "", "long one"}));
  EXPECT_EQ(file.attribute("/group", "kind"), "POLYGON_MESH");
  EXPECT_TRUE(file.has("/deep/er"));
  EXPECT_FALSE(file.has("/deep/er/doubles2"));
  EXPECT_FALSE(file.has("/deeper/er"));
  EXPECT_FALSE(file.has_attribute("/group", "size"));
  EXPECT_EQ(file.children("/numbers"), (std::vector<std::string>{"f32", "f64", "i32"}));
}

TEST(H5File, EigenMatricesGoRowByRow) {
  Eigen::MatrixXd m(2, 3);
  m << 1, 2, 3, 4, 5, 6;
  EXPECT_EQ(h5_matrix(m).values, (std::vector<double>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(eigen_matrix(h5_matrix(m)), m);
  EXPECT_EQ(eigen_matrix(h5_matrix(Eigen::MatrixXd(0, 4))).cols(), 4);
}

TEST(H5File, SameBytesASecondLater) {
  const TemporaryFolder folder;
  write_h5(folder.file("a.h5"), write_everything);
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // HDF5 stores times in whole seconds
  write_h5(folder.file("b.h5"), write_everything);
  EXPECT_EQ(bytes_of(folder.file("a.h5")), bytes_of(folder.file("b.h5")));
}

TEST(H5File, AnErrorWhileWritingLeavesNothing) {
  const TemporaryFolder folder;
  EXPECT_THROW(
      write_h5(folder.file("a.h5"), [](H5Writer& file) { file.string("/a", std::string("x\0y", 3)); }),
      InvalidInput);
  EXPECT_THROW(write_h5(folder.file("a.h5"),
                        [](H5Writer& file) {
                          file.matrix<double>("/a", {2, 2, {1}});
                        }),
               InvalidInput);
  EXPECT_THROW(write_h5(folder.file("a.h5"),
                        [](H5Writer& file) {
                          file.scalar("/a", 1.0);
                          file.scalar("/a", 2.0);
                        }),
               IoError);
  EXPECT_THROW(write_h5(folder.file("a.h5"), [](H5Writer& file) { file.attribute("/none", "a", "b"); }),
               IoError);
  EXPECT_EQ(folder.size(), 0);
}

TEST(H5File, EachMistakeHasItsMessage) {
  const TemporaryFolder folder;
  write_h5(folder.file("a.h5"), write_everything);
  const H5Reader file(folder.file("a.h5"));
  EXPECT_THAT(message([&] { file.scalar<double>("/nowhere"); }), HasSubstr("a.h5: /nowhere: is missing; "));
  EXPECT_THAT(message([&] { file.scalar<double>("/group"); }), HasSubstr("/group: is no dataset"));
  EXPECT_THAT(message([&] { file.vector<float>("/cells"); }),
              HasSubstr("/cells: has shape (2 x 3), not rank 1"));
  EXPECT_THAT(message([&] { file.matrix<float>("/numbers/f32"); }), HasSubstr("has shape (), not rank 2"));
  EXPECT_THAT(message([&] { file.scalar<float>("/deep/er/doubles"); }),
              HasSubstr("has shape (3), not one value"));
  EXPECT_THAT(message([&] { file.vector<std::int32_t>("/deep/er/doubles"); }),
              HasSubstr("holds no integers"));
  EXPECT_THAT(message([&] { file.scalar<float>("/text"); }), HasSubstr("/text: holds no numbers"));
  EXPECT_THAT(message([&] { file.string("/numbers/f32"); }), HasSubstr("holds no text"));
  EXPECT_THAT(message([&] { file.string("/names"); }), HasSubstr("has shape (3), not one text"));
  EXPECT_THAT(message([&] { file.attribute("/group", "size"); }),
              HasSubstr("/group attribute size: is missing"));
  EXPECT_THAT(message([&] { file.children("/text"); }), HasSubstr("/text: is no group"));
  EXPECT_THAT(message([&] { H5Reader(folder.file("none.h5")); }), HasSubstr("no such file"));
  EXPECT_THAT(message([&] { H5Reader(folder.file("b.h5", "text")); }), HasSubstr("is no HDF5 file"));
  const std::string bytes = bytes_of(folder.file("a.h5"));
  EXPECT_THAT(message([&] { H5Reader(folder.file("c.h5", bytes.substr(0, bytes.size() / 2))); }),
              HasSubstr("the file is damaged or cut off"));
  EXPECT_THAT(message([&] { H5Reader(folder.file("d.h5", "")); }), HasSubstr("is empty"));
  EXPECT_THAT(message([&] { write_h5(folder.file("none") / "a.h5", write_everything); }),
              HasSubstr("its folder does not exist"));
}

// A size in the header that exceeds the file must be refused.
TEST(H5File, LyingSizesAreRefusedBeforeMemoryIsTaken) {
  const TemporaryFolder folder;
  write_h5(folder.file("a.h5"),
           [](H5Writer& file) { file.vector<double>("/v", std::vector<double>(0x1234, 1.0)); });
  std::string bytes = bytes_of(folder.file("a.h5"));
  const std::string size("\x34\x12\0\0\0\0\0\0", 8), lie("\x34\x12\0\0\0\x01\0\0", 8);
  int replaced = 0;
  for (auto at = bytes.find(size); at != std::string::npos; at = bytes.find(size, at + 1), ++replaced)
    bytes.replace(at, size.size(), lie);
  ASSERT_GT(replaced, 0);
  try {
    H5Reader(folder.file("b.h5", bytes)).vector<double>("/v");
    FAIL();
  } catch (const IoError& error) {
    EXPECT_THAT(error.what(), HasSubstr("/v: "));
  }
}

TEST(H5File, DamagedFilesAreReadOrRefused) {
  const TemporaryFolder folder;
  write_h5(folder.file("a.h5"),
           [](H5Writer& file) { file.vector<double>("/g/v", std::vector<double>(20, 1.0)); });
  const std::string good = bytes_of(folder.file("a.h5"));
  Rng rng(1);
  int refused = 0;
  for (int round = 0; round < 100; ++round) {
    std::string bytes = good;
    bytes[rng.below(static_cast<int>(bytes.size()))] = static_cast<char>(rng.below(256));
    try {
      EXPECT_LE(H5Reader(folder.file("b.h5", bytes)).vector<double>("/g/v").size(), bytes.size());
    } catch (const IoError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 0);
}

TEST(H5File, WhatTheLibraryDoesNotSurviveIsRefused) {
  const TemporaryFolder folder;
  write_h5(folder.file("a.h5"), [](H5Writer& file) { file.scalar<double>("/x", 3.0); });
  const auto x_of = [](const H5Reader& file) { return file.scalar<double>("/x"); };
  EXPECT_EQ(read_h5(folder.file("a.h5"), x_of), 3.0);
  EXPECT_THAT(message([&] {
                read_h5(folder.file("a.h5"), [](const H5Reader&) {
                  std::raise(SIGSEGV);
                  return 0;
                });
              }),
              AllOf(HasSubstr("a.h5: the HDF5 library does not survive"), HasSubstr("write it again")));
  EXPECT_THAT(message([&] {
                io_detail::require_survival(
                    folder.file("a.h5"),
                    [] {
                      for (volatile int forever = 1; forever != 0;) {
                      }
                    },
                    1);
              }),
              HasSubstr("does not survive"));
  EXPECT_THAT(message([&] {
                read_h5(folder.file("a.h5"), [](const H5Reader& file) { return file.scalar<double>("/y"); });
              }),
              HasSubstr("/y: is missing"))
      << "a refusal is no crash";
}

}  // namespace
}  // namespace foramen
