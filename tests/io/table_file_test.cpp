#include "io/table_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <limits>

#include "foramen/core/error.hpp"
#include "foramen/core/rng.hpp"
#include "support/temporary_folder.hpp"

namespace foramen {
namespace {

using testing::bytes_of;
using testing::TemporaryFolder;

TEST(WriteCsv, QuotesOnlyWhatNeedsIt) {
  const TemporaryFolder folder;
  write_csv(
      folder.file("a.csv"), {"shape", "modes", "error, mm"},
      {{"L1", std::int64_t{3}, 0.1}, {"a \"b\"\nc", std::int64_t{-1}, 1e-300}, {"", std::int64_t{0}, NAN}});
  EXPECT_EQ(bytes_of(folder.file("a.csv")),
            "shape,modes,\"error, mm\"\nL1,3,0.1\n\"a \"\"b\"\"\nc\",-1,1e-300\n,0,nan\n");
}

TEST(WriteCsv, RefusesRaggedRows) {
  const TemporaryFolder folder;
  EXPECT_THROW(write_csv(folder.file("a.csv"), {"a", "b"}, {{1.0, 2.0}, {1.0}}), InvalidInput);
  EXPECT_EQ(folder.size(), 0);
}

TEST(Csv, RoundTripOfHardCells) {
  const TemporaryFolder folder;
  const std::vector<std::string> cells = {"",       "plain", ",",       "\"",       "\"\"",
                                          "a\r\nb", "\n",    " blank ", "\xC3\xA4", "'x'"};
  for (std::size_t columns : {1U, 2U, 5U}) {
    std::vector<std::string> header;
    for (std::size_t c = 0; c < columns; ++c) header.push_back("column \"" + std::to_string(c) + "\"");
    std::vector<Row> rows;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      Row row;
      for (std::size_t c = 0; c < columns; ++c) row.emplace_back(cells[(i + 3 * c) % cells.size()]);
      rows.push_back(row);
    }
    write_csv(folder.file("a.csv"), header, rows);
    const Table table = read_csv(folder.file("a.csv"));
    EXPECT_EQ(table.header, header);
    ASSERT_EQ(table.rows.size(), rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (std::size_t c = 0; c < columns; ++c)
        EXPECT_EQ(table.rows[i][c], std::get<std::string>(rows[i][c]));
  }
}

TEST(FormatNumber, RoundTripsShortestInAnyLocale) {
  EXPECT_EQ(format_number(0.1), "0.1");
  EXPECT_EQ(format_number(-2), "-2");
  EXPECT_EQ(format_number(-std::nan("")), "nan");
  EXPECT_EQ(format_number(-std::numeric_limits<double>::infinity()), "-inf");
  const char* before = std::setlocale(LC_ALL, nullptr);
  const std::string restored = before ? before : "C";
  std::setlocale(LC_ALL, "de_DE.UTF-8");  // this locale has a decimal comma, if it is installed
  Rng rng(2);
  for (int i = 0; i < 1000; ++i) {
    const double value = rng.normal() * std::pow(10.0, rng.uniform(-200, 200));
    EXPECT_EQ(parse_number(format_number(value)), value);
  }
  std::setlocale(LC_ALL, restored.c_str());
  EXPECT_THROW(parse_number("1,5"), IoError);
  EXPECT_THROW(parse_number(""), IoError);
}

TEST(ReadCsv, ForeignLineEndsAndByteOrderMark) {
  const TemporaryFolder folder;
  const Table table = read_csv(folder.file("a.csv", "\xEF\xBB\xBFid,x\r\n\"a\"\"\",1\r\nb,"));
  EXPECT_EQ(table.header, (std::vector<std::string>{"id", "x"}));
  EXPECT_EQ(table.rows, (std::vector<std::vector<std::string>>{{"a\"", "1"}, {"b", ""}}));
  EXPECT_EQ(table.column("x"), 1U);
  EXPECT_THROW(table.column("y"), IoError);
}

TEST(ReadCsv, EachMistakeHasItsLine) {
  const TemporaryFolder folder;
  for (const auto& [bytes, message] : std::vector<std::pair<std::string, std::string>>{
           {"", "is empty"},
           {"\n1\n", "has no header"},
           {"a,b\n1,2\n3\n", "line 3: 1 cells, but the header has 2"},
           {"a,b\n\"x\ny\",2\n3,4,5\n", "line 4: 3 cells"},
           {"a,b\n1,\"2\n3,4\n", "line 2: a quote that is never closed"},
           {"a,b\n1,\"2\"3\n", "line 2: text after a closing quote"},
           {"a,b\n1,2\"3\"\n", "line 2: a quote within '2\"3\"'"}})
    try {
      read_csv(folder.file("a.csv", bytes));
      FAIL() << message;
    } catch (const IoError& error) {
      EXPECT_THAT(error.what(), ::testing::HasSubstr(message));
    }
}

}  // namespace
}  // namespace foramen
