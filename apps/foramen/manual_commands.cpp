// The manual page and the completion scripts of shells. They are generated from the descriptions of the
// commands, so that they agree with the program.
#include <algorithm>
#include <iostream>

#include "command.hpp"
#include "modelfiles/version.hpp"

namespace foramen::app {
namespace {

std::vector<const CLI::App*> commands_of(const CLI::App& program) {
  auto commands = program.get_subcommands([](const CLI::App*) { return true; });
  return {commands.begin(), commands.end()};
}

// The names of an option; "--output" comes before "-o".
std::vector<std::string> names_of(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  return names;
}

bool takes_value(const CLI::Option& option) { return option.get_expected_max() > 0; }

// The words of an option that is a choice. CLI11 gives them in the type name, as "{a,b}".
std::vector<std::string> choices_of(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const auto open = type.find('{'), close = type.find('}');
  std::vector<std::string> choices;
  if (open == std::string::npos || close == std::string::npos) return choices;
  std::string word;
  for (char c : type.substr(open + 1, close - open - 1) + ",") {
    if (c != ',') {
      word += c;
      continue;
    }
    choices.push_back(word);
    word.clear();
  }
  return choices;
}

std::string joined(const std::vector<std::string>& words, const std::string& between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

// The text in single quotes, for a shell.
std::string quoted(const std::string& text) {
  std::string out = "'";
  for (char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

std::string bash_completion(const CLI::App& program) {
  std::vector<std::string> names;
  std::string options, values;
  for (const CLI::App* command : commands_of(program)) {
    names.push_back(command->get_name());
    std::vector<std::string> flags;
    for (const CLI::Option* option : command->get_options())
      for (const std::string& name : names_of(*option)) {
        flags.push_back(name);
        const std::string choices = joined(choices_of(*option), " ");
        if (!choices.empty())
          values += "    " + command->get_name() + ":" + name + ") words='" + choices + "' ;;\n";
      }
    options += "      " + command->get_name() + ") words='" + joined(flags, " ") + "' ;;\n";
  }
  return "# bash completion of foramen: foramen completion bash > "
         "~/.local/share/bash-completion/completions/foramen\n"
         "_foramen() {\n"
         "  local word=${COMP_WORDS[COMP_CWORD]} words=\n"
         "  COMPREPLY=()\n"
         "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
         "    COMPREPLY=($(compgen -W '" +
         joined(names, " ") +
         " --help --version' -- \"$word\"))\n"
         "    return\n"
         "  fi\n"
         "  case ${COMP_WORDS[1]}:${COMP_WORDS[COMP_CWORD - 1]} in\n" +
         values +
         "  esac\n"
         "  if [ -z \"$words\" ] && [[ $word == -* ]]; then\n"
         "    case ${COMP_WORDS[1]} in\n" +
         options +
         "    esac\n"
         "  fi\n"
         "  [ -z \"$words\" ] || COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))\n"
         "}\n"
         "complete -o default -F _foramen foramen\n";
}

// Escapes brackets and colons, which are special characters in zsh's specifications.
std::string zsh_escaped(const std::string& text) {
  std::string out;
  for (char c : text) out += c == '[' || c == ']' || c == ':' ? std::string("\\") + c : std::string(1, c);
  return out;
}

std::string zsh_completion(const CLI::App& program) {
  std::string commands, options;
  for (const CLI::App* command : commands_of(program)) {
    commands += "    " + quoted(command->get_name() + ":" + zsh_escaped(command->get_description())) + "\n";
    options += "    " + command->get_name() + ") _arguments";
    for (const CLI::Option* option : command->get_options())
      for (const std::string& name : names_of(*option)) {
        const auto choices = choices_of(*option);
        options += " \\\n      " + quoted(name + "[" + zsh_escaped(option->get_description()) + "]" +
                                          (!takes_value(*option) ? ""
                                           : choices.empty()     ? ":value:_files"
                                                                 : ":value:(" + joined(choices, " ") + ")"));
      }
    options += " \\\n      '*:file:_files' ;;\n";
  }
  return "#compdef foramen\n"
         "# zsh completion of foramen: foramen completion zsh > a folder of $fpath/_foramen\n"
         "_foramen() {\n"
         "  local -a commands=(\n" +
         commands +
         "  )\n"
         "  if (( CURRENT == 2 )); then\n"
         "    _describe command commands\n"
         "    return\n"
         "  fi\n"
         "  local command=${words[2]}\n"
         "  shift words\n"
         "  (( CURRENT-- ))\n"
         "  case $command in\n" +
         options +
         "  esac\n"
         "}\n"
         "_foramen \"$@\"\n";
}

std::string fish_completion(const CLI::App& program) {
  std::string text =
      "# fish completion of foramen: foramen completion fish > ~/.config/fish/completions/foramen.fish\n";
  for (const CLI::App* command : commands_of(program)) {
    const std::string name = command->get_name();
    text += "complete -c foramen -n __fish_use_subcommand -a " + name + " -d " +
            quoted(command->get_description()) + "\n";
    for (const CLI::Option* option : command->get_options()) {
      if (names_of(*option).empty()) continue;
      text += "complete -c foramen -n '__fish_seen_subcommand_from " + name + "'";
      for (const std::string& s : option->get_snames()) text += " -s " + s;
      for (const std::string& l : option->get_lnames()) text += " -l " + l;
      const auto choices = choices_of(*option);
      if (!choices.empty())
        text += " -x -a " + quoted(joined(choices, " "));
      else if (takes_value(*option))
        text += " -r";
      text += " -d " + quoted(option->get_description()) + "\n";
    }
  }
  return text;
}

// Escapes what is special in roff: backslashes, dashes, and a dot or quote at the beginning of a line.
std::string roff(const std::string& text) {
  std::string out;
  bool line_begins = true;
  for (char c : text) {
    if (line_begins && (c == '.' || c == '\'')) out += "\\&";
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else
      out += c;
    line_begins = c == '\n';
  }
  return out;
}

// The lines of a help footer, without filling.
std::string example(const std::string& text) {
  return text.empty() ? "" : ".PP\n.nf\n" + roff(text) + "\n.fi\n";
}

std::string manual_page(const CLI::App& program) {
  std::string text = ".TH FORAMEN 1 \"\" \"foramen " + version() +
                     "\" \"User commands\"\n"
                     ".SH NAME\nforamen \\- statistical shape models of vertebrae, automatically\n"
                     ".SH SYNOPSIS\n.B foramen\n.I command\n[options] ...\n"
                     ".SH COMMANDS\n";
  for (const CLI::App* command : commands_of(program)) {
    text += ".SS foramen " + command->get_name();
    for (const CLI::Option* option : command->get_options())
      if (names_of(*option).empty())
        text += " " + roff(option->get_name()) + (option->get_expected_max() > 1 ? " ..." : "");
    text += "\n" + roff(command->get_description()) + "\n";
    for (const CLI::Option* option : command->get_options()) {
      const auto names = names_of(*option);
      if (names.empty()) continue;
      const auto choices = choices_of(*option);
      const std::string value = !takes_value(*option) ? ""
                                : choices.empty()     ? " VALUE"
                                                      : " " + joined(choices, "|");
      text += ".TP\n.B " + roff(joined(names, ", ") + value) + "\n" + roff(option->get_description()) + "\n";
    }
    text += example(command->get_footer());
  }
  return text +
         ".SH EXIT STATUS\n.TP\n.B 0\ndone\n.TP\n.B 1\nan input or a result was refused\n.TP\n.B 2\nthe "
         "command "
         "line was not understood\n.TP\n.B 3\nan optimisation did not converge\n.TP\n.B 130\nstopped by "
         "Ctrl\\-C\n"
         ".SH SEE ALSO\nBecker, Kirschner, Fuhrmann, Wesarg: Automatic Construction of Statistical Shape "
         "Models for Vertebrae. MICCAI 2011.\n";
}

}  // namespace

void add_manual(CLI::App& program, Run& run) {
  CLI::App* command = program.add_subcommand("manual", "prints the manual page");
  command->footer("Example:\n  foramen manual | man -l -");
  command->callback([&program, &run] {
    run = [&program] {
      std::cout << manual_page(program);
      return ExitCode::done;
    };
  });
}

void add_completion(CLI::App& program, Run& run) {
  auto shell = std::make_shared<std::string>();
  CLI::App* command = program.add_subcommand("completion", "prints the completion of a shell");
  command->footer("Example:\n  foramen completion bash > ~/.local/share/bash-completion/completions/foramen");
  command->add_option("shell", *shell, "bash, zsh or fish")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
  command->callback([shell, &program, &run] {
    run = [shell, &program] {
      std::cout << (*shell == "bash"  ? bash_completion(program)
                    : *shell == "zsh" ? zsh_completion(program)
                                      : fish_completion(program));
      return ExitCode::done;
    };
  });
}

}  // namespace foramen::app
