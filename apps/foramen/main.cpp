#include <iostream>
#include <string>

#include "command.hpp"
#include "foramen/core/error.hpp"
#include "modelfiles/version.hpp"
#include "remedy_words.hpp"

namespace {

using namespace foramen;
using namespace foramen::app;

int run_program(int argc, char** argv) {
  CLI::App program{
      "foramen: statistical shape models of vertebrae, automatically\n"
      "Example: foramen build shapes/ -o model"};
  program.set_version_flag("--version", "foramen " + version());
  program.require_subcommand(1);
  program.option_defaults()->always_capture_default();  // the help shows defaults
  Run run;
  add_demo(program, run);
  add_synth(program, run);
  add_inspect(program, run);
  add_extract(program, run);
  add_repair(program, run);
  add_build(program, run);
  add_evaluate(program, run);
  add_compare(program, run);
  add_convert(program, run);
  add_sample(program, run);
  add_modes(program, run);
  add_reconstruct(program, run);
  add_project(program, run);
  add_complete(program, run);
  add_measure(program, run);
  add_report(program, run);
  add_render(program, run);
  add_completion(program, run);
  add_manual(program, run);
  for (CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
    for (CLI::Option* option : command->get_options())
      if (option->get_required()) option->default_str("");  // a required option has no default
  try {
    program.parse(argc, argv);
  } catch (const CLI::RequiredError& e) {
    if (argc < 2 || !program.get_subcommands().empty() || argv[1][0] == '-')
      return program.exit(e) == 0 ? ExitCode::done : ExitCode::usage;
    std::cerr << "foramen: there is no command " << argv[1] << "; `foramen --help` lists the commands\n";
    return ExitCode::usage;
  } catch (const CLI::ParseError& e) {
    return program.exit(e) == 0 ? ExitCode::done : ExitCode::usage;
  }
  const int code = run();
  end_run(code);
  return code;
}

int fail(const std::string& what, ExitCode code) {
  end_run(code, what);
  std::cerr << "foramen: " << what << '\n';
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  std::string command = "foramen";
  for (int i = 1; i < argc; ++i) command += std::string(" ") + argv[i];
  begin_run(command);
  try {
    return run_program(argc, argv);
  } catch (const Cancelled&) {
    return fail("stopped; nothing was left half-written", ExitCode::cancelled);
  } catch (const ConvergenceError& e) {
    return fail(worded(e), ExitCode::not_converged);
  } catch (const std::bad_alloc&) {
    return fail("out of memory", ExitCode::refused);
  } catch (const std::exception& e) {
    return fail(worded(e), ExitCode::refused);
  }
}
