#include <iostream>

#include <nlohmann/json.hpp>

#include "command.hpp"
#include "workflow/write_pictures.hpp"

namespace foramen::app {
namespace {

using nlohmann::ordered_json;

struct RenderCommand {
  PicturesRequest request;
  Console console;
};

int render(const RenderCommand& command) {
  auto captions = ordered_json::object();
  for (const WrittenPicture& picture : write_pictures(command.request)) {
    command.console.say(picture.file.string() + ": " + picture.caption);
    captions[picture.file.filename().string()] = picture.caption;
  }
  // Names of shapes and folders may be invalid UTF-8, but JSON must be valid UTF-8.
  if (command.console.json)
    std::cout << ordered_json{{"folder", command.request.output.string()}, {"files", captions}}.dump(
                     2, ' ', false, ordered_json::error_handler_t::replace)
              << '\n';
  return ExitCode::done;
}

}  // namespace

void add_render(CLI::App& program, Run& run) {
  auto options = std::make_shared<RenderCommand>();
  PicturesRequest& request = options->request;
  CLI::App* command = program.add_subcommand(
      "render",
      "pictures of a model as PNG, curves as SVG and PDF (under xvfb-run where there is no display)");
  command->footer(
      "Examples:\n"
      "  xvfb-run -a foramen render model -o pictures\n"
      "  xvfb-run -a foramen render model --baseline model_icp -o pictures\n"
      "  foramen render model --baseline model_icp --only-curves -o curves");
  command->add_option("model", request.model, "folder of a model")->required();
  command->add_option("-o,--output", request.output, "folder to write")->required();
  command->add_option(
      "--baseline", request.render.baseline,
      "folder of another model: curves of both, first modes and flipped triangles side by side");
  command->add_flag("--only-curves", request.render.only_curves,
                    "no pictures: needs no display, only metrics");
  add_console_options(*command, options->console);
  command->callback([options, &run] { run = [options] { return render(*options); }; });
}

}  // namespace foramen::app
