// The manual page and the completions contain every command and option of the program.
#include <cstdlib>
#include <regex>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/program.hpp"
#include "support/temporary_folder.hpp"

namespace foramen {
namespace {

using ::testing::HasSubstr;
using testing::Outcome;
using testing::run;
using testing::TemporaryFolder;

std::set<std::string> matches(const std::string& text, const std::string& pattern) {
  std::set<std::string> found;
  const std::regex expression(pattern);
  for (std::sregex_iterator it(text.begin(), text.end(), expression), end; it != end; ++it)
    found.insert(it->str(1));
  return found;
}

std::set<std::string> commands() {
  const std::string help = run("--help").output;
  return matches(help.substr(help.find("Subcommands:")), "\\n  ([a-z]+) ");
}

bool there(const std::string& program) {
  return std::system(("command -v " + program + " >/dev/null").c_str()) == 0;
}

TEST(Manual, NamesEveryCommandAndOption) {
  const std::string page = run("manual").output;
  ASSERT_GE(commands().size(), 12u);
  for (const std::string& command : commands()) {
    EXPECT_THAT(page, HasSubstr(".SS foramen " + command));
    for (const std::string& option : matches(run(command + " --help").output, "(--[a-z-]+)")) {
      std::string escaped;
      for (char c : option) escaped += c == '-' ? std::string("\\-") : std::string(1, c);
      EXPECT_THAT(page, HasSubstr(escaped)) << command;
    }
  }
}

TEST(Manual, EveryCommandHasAnExample) {
  for (const std::string& command : commands())
    EXPECT_THAT(run(command + " --help").output, HasSubstr("foramen " + command)) << command;
}

TEST(Manual, ManReadsItWithoutComplaint) {
  if (!there("groff")) GTEST_SKIP() << "groff is not installed";
  const TemporaryFolder folder;
  const auto page = folder.file("foramen.1", run("manual").output);
  const Outcome outcome = testing::run_shell("groff -man -Tutf8 -ww -z " + page.string());
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.output, "");
}

// The words that bash offers for completion.
std::string completed(const std::string& words) {
  const TemporaryFolder folder;
  const auto script = folder.file("completion", run("completion bash").output);
  return testing::run_shell("bash -c '. " + script.string() + "; COMP_WORDS=(" + words +
                            "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _foramen; echo ${COMPREPLY[@]}'")
      .output;
}

TEST(Completion, BashCompletesCommandsOptionsAndChoices) {
  EXPECT_EQ(completed("foramen ex"), "extract\n");
  EXPECT_EQ(completed("foramen build --sub"), "--subject-regex\n");
  EXPECT_EQ(completed("foramen build --bending s"), "smooth\n");
  EXPECT_EQ(completed("foramen build shapes/"), "\n") << "files are left to the shell";
}

TEST(Completion, TheOthersNameEveryCommand) {
  for (const std::string shell : {"zsh", "fish"}) {
    const std::string text = run("completion " + shell).output;
    for (const std::string& command : commands()) EXPECT_THAT(text, HasSubstr(command)) << shell;
    EXPECT_THAT(text, HasSubstr("subject-regex"));
  }
  EXPECT_EQ(run("completion csh").code, 2);
}

}  // namespace
}  // namespace foramen
