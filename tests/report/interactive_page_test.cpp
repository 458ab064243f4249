#include "report/interactive_page.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "report/viewer_template.hpp"

namespace foramen {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(FilledTemplate, PutsTheDataInTheirPlace) {
  EXPECT_EQ(filled_template("<a>@REPORT_DATA@</a>", R"({"x":1})"), R"(<a>{"x":1}</a>)");
}

TEST(FilledTemplate, TextFromFilesCannotEndTheElement) {
  const std::string html = filled_template("@REPORT_DATA@", R"({"name":"</script><!--"})");
  EXPECT_EQ(html, R"({"name":"\u003c/script>\u003c!--"})");
}

TEST(FilledTemplate, NeedsOnePlace) {
  EXPECT_THROW(filled_template("none", "{}"), InternalError);
  EXPECT_THROW(filled_template("@REPORT_DATA@ @REPORT_DATA@", "{}"), InternalError);
}

TEST(InteractivePage, LoadsNothingFromElsewhere) {
  if (!has_viewer()) GTEST_SKIP() << "this build has no viewer: npm was not found";
  const std::string html = interactive_html("{}");
  for (const char* outside : {"src=\"", "href=\"http", "@import", "url(http"})
    EXPECT_THAT(html, Not(HasSubstr(outside)));
  EXPECT_THAT(html, HasSubstr("type=\"application/json\">{}</script>"));
}

}  // namespace
}  // namespace foramen
