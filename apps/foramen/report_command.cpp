#include "command.hpp"
#include "workflow/write_report.hpp"

namespace foramen::app {
namespace {

struct ReportCommand {
  ReportRequest request;
  bool plain = false;
  Console console;
};

int report(const ReportCommand& command) {
  const WrittenReport written = write_report(command.request);
  command.console.say(written.file.string() + ": " + written.remark);
  return ExitCode::done;
}

}  // namespace

void add_report(CLI::App& program, Run& run) {
  auto options = std::make_shared<ReportCommand>();
  ReportRequest& request = options->request;
  CLI::App* command = program.add_subcommand("report", "writes a model's report.html again");
  command->footer("Example:\n  foramen report model --baseline model_icp");
  command->add_option("model", request.model, "folder of a model")->required();
  command->add_option("-o,--output", request.output, "another file to write");
  command->add_option("--baseline", request.page.baseline,
                      "folder of another model, to compare with: curves and differences");
  command->add_flag("--plain", options->plain, "the plain page, also where the interactive one is built in");
  add_console_options(*command, options->console);
  command->callback([options, &run] {
    if (options->plain) options->request.page.kind = PageKind::plain;
    run = [options] { return report(*options); };
  });
}

}  // namespace foramen::app
