#include "report/pdf_chart.hpp"

#include <array>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/chart_drawing.hpp"
#include "support/temporary_folder.hpp"

namespace foramen {
namespace {

using ::testing::HasSubstr;

Chart two_curves() {
  return {"Specificity (Hausdorff)",
          "number of modes",
          "distance, mm \\",
          {{"Modèle ±", {1, 2, 3}, {1.0, 2.0, 4.0}, {0.1, 0.1, 0.2}},
           {"baseline: 模", {1, 2, 3}, {2.0, 3.0, 3.5}, {}}}};
}

// Every entry of the table of objects is where that object begins, and the last line but one says where the
// table is.
TEST(PdfChart, ObjectsAreWhereTheTableSays) {
  const std::string pdf = pdf_chart(two_curves());
  const std::size_t table = std::stoul(pdf.substr(pdf.rfind("startxref\n") + 10));
  ASSERT_EQ(pdf.substr(table, 5), "xref\n");
  std::istringstream lines(pdf.substr(table));
  std::string line;
  std::getline(lines, line);
  std::getline(lines, line);
  const int count = std::stoi(line.substr(2));
  EXPECT_EQ(count, 8);
  for (int i = 0; i < count; ++i) {
    std::getline(lines, line);
    ASSERT_EQ(line.size() + 1, 20u);
    const std::string begin = std::to_string(i) + " 0 obj";
    if (i > 0) {
      EXPECT_EQ(pdf.substr(std::stoul(line), begin.size()), begin);
    }
  }
  EXPECT_EQ(pdf_chart(two_curves()), pdf);
}

TEST(PdfChart, ItsStreamIsAsLongAsItSays) {
  const std::string pdf = pdf_chart(two_curves());
  const std::size_t at = pdf.find("/Length ");
  const std::size_t begin = pdf.find("stream\n", at) + 7;
  EXPECT_EQ(pdf.substr(begin + std::stoul(pdf.substr(at + 8)), 9), "endstream");
}

// Poppler's programs are another's reading of the file.
class ReadByPoppler : public ::testing::Test {
 protected:
  void SetUp() override {
    if (std::system("command -v pdftotext pdftoppm >/dev/null 2>&1") != 0)
      GTEST_SKIP() << "needs pdftotext and pdftoppm (poppler-utils)";
    std::ofstream(folder_.file("chart.pdf"), std::ios::binary) << pdf_chart(two_curves());
  }
  std::string output_of(const std::string& command, const char* file) const {
    const std::string messages = folder_.file("messages").string();
    EXPECT_EQ(std::system((command + " 2> " + messages).c_str()), 0);
    std::ostringstream told, out;
    told << std::ifstream(messages).rdbuf();
    EXPECT_THAT(told.str(), ::testing::Not(HasSubstr("Error")));
    out << std::ifstream(folder_.file(file), std::ios::binary).rdbuf();
    return out.str();
  }
  std::string path(const char* file) const { return folder_.file(file).string(); }

 private:
  testing::TemporaryFolder folder_;
};

TEST_F(ReadByPoppler, TheTextIsTheCharts) {
  const std::string text =
      output_of("pdftotext -layout " + path("chart.pdf") + " " + path("chart.txt"), "chart.txt");
  for (const char* part :
       {"Specificity (Hausdorff)", "number of modes", "distance, mm \\", "Modèle ±", "baseline: ?"})
    EXPECT_THAT(text, HasSubstr(part));
}

// At 72 dpi a pixel is a unit of the drawing.
TEST_F(ReadByPoppler, DotsAreWhereTheDrawingHasThem) {
  const std::string ppm =
      output_of("pdftoppm -r 72 -aa no -singlefile " + path("chart.pdf") + " " + path("chart"), "chart.ppm");
  const Drawing drawing = chart_drawing(two_curves());
  std::istringstream header(ppm);
  std::string magic;
  std::size_t width = 0, height = 0, most = 0;
  header >> magic >> width >> height >> most;
  ASSERT_EQ(magic, "P6");
  EXPECT_EQ(static_cast<double>(width), drawing.width);
  EXPECT_EQ(static_cast<double>(height), drawing.height);
  const std::size_t first = static_cast<std::size_t>(header.tellg()) + 1;
  const auto pixel = [&](const Vec2& at) {
    const std::size_t i =
        first + 3 * (static_cast<std::size_t>(at.y()) * width + static_cast<std::size_t>(at.x()));
    std::uint32_t colour = 0;
    for (std::size_t k = 0; k < 3; ++k) colour = colour << 8 | static_cast<unsigned char>(ppm.at(i + k));
    return colour;
  };
  int dots = 0;
  for (const DrawnPart& part : drawing.parts)
    for (const DrawnDot& dot : part.dots) {
      EXPECT_EQ(pixel(dot.centre), series_colours[*part.series]) << dot.centre.transpose();
      ++dots;
    }
  EXPECT_EQ(dots, 6);
  EXPECT_EQ(pixel({2, 2}), 0xFFFFFFu);
}

}  // namespace
}  // namespace foramen
