#include <filesystem>
#include <iostream>

#include <nlohmann/json.hpp>

#include "command.hpp"
#include "pages/render_model.hpp"
#include "workflow/write_report.hpp"

namespace foramen::app {
namespace {

namespace fs = std::filesystem;

struct PictureCommand {
  std::string model, output, baseline;
  bool plain = false, only_curves = false;
  Console console;
};

int render(const PictureCommand& command) {
  const fs::path folder = command.output;
  const auto files =
      render_model(command.model, {.baseline = command.baseline, .only_curves = command.only_curves});
  const nlohmann::ordered_json captions = write_rendered(files, folder);
  for (const RenderedFile& file : files)
    command.console.say((folder / file.name).string() + ": " + file.caption);
  // Names of shapes and folders may be invalid UTF-8, but JSON must be valid UTF-8.
  if (command.console.json)
    std::cout << nlohmann::ordered_json{{"folder", command.output}, {"files", captions}}.dump(
                     2, ' ', false, nlohmann::ordered_json::error_handler_t::replace)
              << '\n';
  return ExitCode::done;
}

int report(const PictureCommand& command) {
  ReportRequest request{
      .model = command.model, .output = command.output, .page = {.baseline = command.baseline}};
  if (command.plain) request.page.kind = PageKind::plain;
  const WrittenReport written = write_report(request);
  command.console.say(written.file.string() + ": " + written.remark);
  return ExitCode::done;
}

}  // namespace

void add_render(CLI::App& program, Run& run) {
  auto options = std::make_shared<PictureCommand>();
  CLI::App* command = program.add_subcommand(
      "render",
      "pictures of a model as PNG, curves as SVG and PDF (under xvfb-run where there is no display)");
  command->footer(
      "Examples:\n"
      "  xvfb-run -a foramen render model -o pictures\n"
      "  xvfb-run -a foramen render model --baseline model_icp -o pictures\n"
      "  foramen render model --baseline model_icp --only-curves -o curves");
  command->add_option("model", options->model, "folder of a model")->required();
  command->add_option("-o,--output", options->output, "folder to write")->required();
  command->add_option(
      "--baseline", options->baseline,
      "folder of another model: curves of both, first modes and flipped triangles side by side");
  command->add_flag("--only-curves", options->only_curves, "no pictures: needs no display, only metrics");
  add_console_options(*command, options->console);
  command->callback([options, &run] { run = [options] { return render(*options); }; });
}

void add_report(CLI::App& program, Run& run) {
  auto options = std::make_shared<PictureCommand>();
  CLI::App* command = program.add_subcommand("report", "writes a model's report.html again");
  command->footer("Example:\n  foramen report model --baseline model_icp");
  command->add_option("model", options->model, "folder of a model")->required();
  command->add_option("-o,--output", options->output, "another file to write");
  command->add_option("--baseline", options->baseline,
                      "folder of another model, to compare with: curves and differences");
  command->add_flag("--plain", options->plain, "the plain page, also where the interactive one is built in");
  add_console_options(*command, options->console);
  command->callback([options, &run] { run = [options] { return report(*options); }; });
}

}  // namespace foramen::app
