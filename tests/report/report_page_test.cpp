#include "report/report_page.hpp"

#include <algorithm>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/html_text.hpp"

namespace foramen {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(Base64, TestVectorsOfRfc4648) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64(std::string("\xff\x00\xfe", 3)), "/wD+");
}

TEST(ReportPage, TextFromFilesCannotBecomeMarkup) {
  ReportPage page{"<script>1</script>", "a & b", {}};
  page.sections.push_back({.title = "s\"",
                           .paragraphs = {"<img>"},
                           .findings = {"<i>"},
                           .tables = {{"t", "", {"h"}, {{"<b>"}}}}});
  const std::string html = report_html(page);
  EXPECT_THAT(html, Not(HasSubstr("<script>")));
  EXPECT_THAT(html, Not(HasSubstr("<b>")));
  EXPECT_THAT(html, Not(HasSubstr("<i>")));
  EXPECT_THAT(html, HasSubstr("&lt;img&gt;"));
  EXPECT_THAT(html, HasSubstr("a &amp; b"));
}

TEST(ReportPage, LoadsNothingFromElsewhere) {
  ReportPage page{"t", "", {{.title = "s", .pictures = {{"picture", "png"}}}}};
  const std::string html = report_html(page);
  for (const char* outside : {"src=\"http", "href=\"http", "@import", "url("})
    EXPECT_THAT(html, Not(HasSubstr(outside)));
  EXPECT_THAT(html, HasSubstr("data:image/png;base64,cG5n"));
}

// The vertical place of the n-th circle of a chart.
double circle_y(const std::string& svg, int n) {
  std::size_t at = 0;
  for (int i = 0; i <= n; ++i) at = svg.find("<circle", at + 1);
  return std::stod(svg.substr(svg.find("cy=\"", at) + 4));
}

TEST(SvgChart, PlacesPointsByTheirValues) {
  const std::string svg =
      svg_chart({"t", "modes", "mm", {{"a", {1, 2, 3}, {1.0, 2.0, 4.0}, {0.1, 0.1, 0.2}}}});
  const double y1 = circle_y(svg, 0), y2 = circle_y(svg, 1), y3 = circle_y(svg, 2);
  EXPECT_GT(y1, y2);
  EXPECT_NEAR((y1 - y2) * 2, y2 - y3, 0.05);
}

// The legend is above the plot: all points of the curves are below its last line.
TEST(SvgChart, TheLegendHidesNoCurve) {
  Chart chart{"t", "modes", "mm", {}};
  for (int i = 0; i < 5; ++i)
    chart.series.push_back({std::string("model ").append(std::to_string(i)), {1, 2}, {1.0, 2.0 + i}, {}});
  const std::string svg = svg_chart(chart);
  double lowest_name = 0, highest_point = 1e9;
  for (const ChartSeries& s : chart.series) {
    const std::size_t at = svg.rfind("<text", svg.find(">" + s.name + "<"));
    lowest_name = std::max(lowest_name, std::stod(svg.substr(svg.find(" y=\"", at) + 4)));
  }
  for (int i = 0; i < 10; ++i) highest_point = std::min(highest_point, circle_y(svg, i));
  EXPECT_LT(lowest_name, highest_point);
  EXPECT_THAT(svg_chart({"one", "x", "y", {{"alone", {1}, {1}, {}}}}), Not(HasSubstr("alone")));
}

TEST(SvgChart, AChartWithoutPointsIsStillAChart) {
  EXPECT_THAT(svg_chart({"empty", "x", "y", {}}), HasSubstr("</svg>"));
  EXPECT_THAT(svg_chart({"flat", "x", "y", {{"a", {1}, {0}, {}}}}), Not(HasSubstr("nan")));
}

TEST(SvgChart, AFileOfItsOwnIsOnWhite) {
  const Chart chart{"t", "x", "y", {{"a", {1, 2}, {1, 2}, {}}}};
  EXPECT_THAT(svg_chart(chart), Not(HasSubstr("white")));
  EXPECT_THAT(svg_chart_file(chart), HasSubstr("fill=\"white\""));
  EXPECT_THAT(svg_chart_file(chart), HasSubstr(" width=\"440\" height=\"300\""));
}

}  // namespace
}  // namespace foramen
