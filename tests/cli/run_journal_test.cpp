// The journal of a run: --events and --log.
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/program.hpp"
#include "support/temporary_folder.hpp"

namespace foramen {
namespace {

using testing::bytes_of;
using ::testing::HasSubstr;
using testing::Outcome;
using testing::run;
using testing::TemporaryFolder;

std::vector<nlohmann::json> events_in(const std::string& text) {
  std::vector<nlohmann::json> events;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) events.push_back(nlohmann::json::parse(line));
  return events;
}

TEST(RunJournal, EventsGoFromStartToEnd) {
  const TemporaryFolder folder;
  const auto path = (folder.path() / "events").string();
  ASSERT_EQ(
      run("synth -n 3 --vertices 2500 --quiet --events " + path + " -o " + (folder.path() / "s").string())
          .code,
      0);
  const auto events = events_in(bytes_of(path));
  ASSERT_GE(events.size(), 3u);
  EXPECT_EQ(events.front().at("event"), "started");
  EXPECT_THAT(events.front().at("command").get<std::string>(), HasSubstr("synth -n 3"));
  EXPECT_EQ(events.back().at("event"), "ended");
  EXPECT_EQ(events.back().at("exit_code"), 0);
  EXPECT_TRUE(events.back().at("error").is_null());
  double seconds = 0, fraction = 0;
  for (const auto& event : events) {
    if (event.at("event") == "started") continue;
    EXPECT_GE(event.at("seconds").get<double>(), seconds);
    seconds = event.at("seconds");
    if (event.at("event") == "progress" && event.at("stage") == "synth") {
      EXPECT_GT(event.at("fraction").get<double>(), fraction);
      fraction = event.at("fraction");
    }
  }
  EXPECT_GT(fraction, 0.3);
}

TEST(RunJournal, AnErrorEndsTheEventsAndTheLog) {
  const TemporaryFolder folder;
  const auto bad = folder.file("bad.ply", "no mesh"), log = folder.file("log", "earlier\n");
  const Outcome outcome = run("build " + bad.string() + " -o " + (folder.path() / "m").string() +
                              " --events - --log " + log.string());
  EXPECT_EQ(outcome.code, 1);
  std::string lines;
  std::istringstream text(outcome.output);
  for (std::string line; std::getline(text, line);)
    if (line.starts_with('{')) lines += line + "\n";
  const auto events = events_in(lines);
  ASSERT_FALSE(events.empty());
  EXPECT_EQ(events.back().at("event"), "ended");
  EXPECT_EQ(events.back().at("exit_code"), 1);
  EXPECT_THAT(events.back().at("error").get<std::string>(), HasSubstr("bad.ply"));
  const std::string logged = bytes_of(log);
  EXPECT_TRUE(logged.starts_with("earlier\n")) << "a log is appended to";
  EXPECT_THAT(logged, HasSubstr("exit code 1"));
  EXPECT_THAT(logged, HasSubstr("bad.ply"));
}

TEST(RunJournal, APlaceThatCannotBeWrittenIsNamed) {
  const TemporaryFolder folder;
  for (const std::string option : {"--events", "--log"}) {
    const Outcome outcome = run("synth -n 3 --vertices 2500 " + option + " /no/such/folder/file -o " +
                                (folder.path() / "s").string());
    EXPECT_EQ(outcome.code, 1);
    EXPECT_THAT(outcome.output, HasSubstr("/no/such/folder/file: cannot be written"));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "s"));
  }
}

}  // namespace
}  // namespace foramen
