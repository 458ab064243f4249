#include <algorithm>
#include <filesystem>

#include "command.hpp"

namespace foramen::app {

namespace fs = std::filesystem;

std::string canonical_command(const CLI::App& command, const std::vector<std::string>& inputs) {
  static const std::vector<std::string> without{"--output", "--truth", "--threads", "--resume",
                                                "--json",   "--quiet", "--events",  "--log",
                                                "--store",  "inputs",  "--help"};
  std::string text = "foramen " + command.get_name();
  for (const std::string& input : inputs)
    text += " " + fs::path(input).lexically_normal().filename().string();
  for (const CLI::Option* option : command.get_options()) {
    const std::string name = option->get_single_name();
    const std::string shown = option->get_lnames().empty() ? name : "--" + option->get_lnames().front();
    if (option->count() == 0 || std::find(without.begin(), without.end(), shown) != without.end()) continue;
    text += " " + shown;
    if (option->get_expected_max() > 0)  // the option takes a value
      for (const std::string& value : option->results())
        text += " " + (shown == "--label-names" ? fs::path(value).filename().string() : value);
  }
  return text;
}

}  // namespace foramen::app
