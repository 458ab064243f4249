// Spreadsheets and the archives that they are.
#include "io/xlsx_sheet.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "foramen/core/rng.hpp"
#include "io/shapeworks_project.hpp"
#include "io/zip_bytes.hpp"
#include "support/temporary_folder.hpp"

namespace foramen {
namespace {

using ::testing::HasSubstr;
using testing::spreadsheet;
using testing::TemporaryFolder;
using testing::zip_bytes;
using Rows = std::vector<io_detail::SheetRow>;

Rows read(const std::string& bytes) { return io_detail::read_sheet({"file", bytes}, "data"); }

std::string refusal(const std::string& bytes) {
  try {
    read(bytes);
  } catch (const IoError& e) {
    return e.what();
  }
  return "not refused";
}

const std::string names =
    R"(<row r="1"><c r="A1" t="s"><v>0</v></c><c r="C1" t="inlineStr"><is><t>age</t></is></c>)"
    R"(<c r="AB1" t="str"><v>note</v></c></row>)";
const std::string texts =
    R"(<si><t>name</t></si><si><r><t>ver</t></r><r><t>tebra</t></r><rPh><t>x</t></rPh></si>)";

TEST(XlsxSheet, CellsOfEveryKind) {
  const std::string rows =
      names + R"(<row r="2"><c r="A2" t="s"><v>1</v></c><c r="B2"><v>9</v></c><c r="C2"><v>61.5</v></c>)"
              R"(<c r="AB2" t="b"><f>TRUE()</f><v>1</v></c></row><row r="3"/><row r="4"><c r="A4"/></row>)"
              R"(<row><c t="inlineStr"><is><t>a &amp; b</t></is></c><c/><c><v>2</v></c></row>)";
  const Rows expected{{{"name", "vertebra"}, {"age", "61.5"}, {"note", "1"}},
                      {{"name", "a & b"}, {"age", "2"}}};
  for (const bool deflate : {true, false})
    EXPECT_EQ(read(zip_bytes(spreadsheet(rows, texts), deflate)), expected);
}

TEST(XlsxSheet, NamesWithAPrefix) {
  testing::ZipFiles files = spreadsheet("");
  files[0].second =
      R"(<x:workbook xmlns:x="s" xmlns:r="u"><x:sheets><x:sheet name="data" r:id="rId7"/></x:sheets>)"
      R"(</x:workbook>)";
  files[3].second = R"(<x:worksheet xmlns:x="s"><x:sheetData><x:row><x:c t="str"><x:v>a</x:v></x:c></x:row>)"
                    R"(<x:row><x:c><x:v>1</x:v></x:c></x:row></x:sheetData></x:worksheet>)";
  files.pop_back();  // a spreadsheet without shared texts
  EXPECT_EQ(read(zip_bytes(files)), (Rows{{{"a", "1"}}}));
}

TEST(XlsxSheet, WhatCannotBeUsedIsNamed) {
  const std::string good = zip_bytes(spreadsheet(names, texts));
  EXPECT_THAT(refusal(good.substr(0, good.size() / 2)), HasSubstr("is an archive that is cut off"));
  EXPECT_THAT(refusal(zip_bytes({{"a.txt", "a"}})), HasSubstr("is no spreadsheet"));
  testing::ZipFiles other = spreadsheet(names);
  other[0].second = "<workbook/>";
  EXPECT_THAT(refusal(zip_bytes(other)), HasSubstr("is a spreadsheet without a sheet 'data'"));
  EXPECT_THAT(refusal(zip_bytes(spreadsheet(names, ""))), HasSubstr("a cell has text '0' of 0"));
  std::string damaged = zip_bytes(spreadsheet(names, texts), false);
  damaged[damaged.find("rId7")] = 'x';
  EXPECT_THAT(refusal(damaged), HasSubstr("'xl/workbook.xml' is damaged"));
  std::string secret = good;
  for (auto at = secret.find("PK\1\2"); at != std::string::npos; at = secret.find("PK\1\2", at + 1))
    secret[at + 8] = 1;
  EXPECT_THAT(refusal(secret), HasSubstr("is encrypted"));
}

TEST(XlsxSheet, SizesAreLimited) {
  const std::string blanks(std::size_t{17} << 20U, ' ');
  EXPECT_THAT(refusal(zip_bytes(spreadsheet(blanks))), HasSubstr("is too large when it is unpacked"));
  // Every part is small, but many cells share one long text.
  const std::string text = "<si><t>" + std::string(std::size_t{1} << 20U, 'a') + "</t></si>";
  std::string row = "<row>";
  for (int i = 0; i < 20; ++i) row += "<c t=\"s\"><v>0</v></c>";
  EXPECT_THAT(refusal(zip_bytes(spreadsheet(row + "</row>", text))),
              HasSubstr("is too large when it is unpacked"));
}

TEST(XlsxSheet, DamagedIsReadSoundOrRefused) {
  Rng rng(7);
  int refused = 0;
  for (const bool deflate : {true, false}) {
    const std::string whole = zip_bytes(spreadsheet(names, texts), deflate);
    for (int round = 0; round < 1000; ++round) {
      std::string bytes = whole;
      for (int change = 0; change <= rng.below(3); ++change)
        bytes[rng.below(static_cast<int>(bytes.size()))] = static_cast<char>(rng.below(256));
      refused += refusal(bytes) == "not refused" ? 0 : 1;
    }
  }
  EXPECT_GT(refused, 1000);
}

TEST(XlsxSheet, AProjectOfShapeWorks) {
  const auto row = [](const std::vector<std::string>& cells) {
    std::string xml = "<row>";
    for (const std::string& cell : cells) xml += "<c t=\"str\"><v>" + cell + "</v></c>";
    return xml + "</row>";
  };
  const TemporaryFolder folder;
  const auto project = read_shapeworks(folder.file(
      "a.xlsx",
      zip_bytes(spreadsheet(row({"name", "shape_1", "local_particles_1", "procrustes_1", "age"}) +
                            row({"a", "in\\a.ply", "p/a.particles", "", "61"}) +
                            row({"b", "in/b.ply", "p/b.particles", "2 0 0 0 0 2 0 0 0 0 2 0 0 0 0 1"})))));
  ASSERT_EQ(project.size(), 2U);
  EXPECT_EQ(project[0].shape, "in/a.ply");
  EXPECT_TRUE(project[0].procrustes.isIdentity(0));
  EXPECT_EQ(project[1].local_particles, "p/b.particles");
  EXPECT_EQ(project[1].procrustes(1, 1), 2);
}

}  // namespace
}  // namespace foramen
