#include <iostream>

#include <nlohmann/json.hpp>

#include "command.hpp"
#include "described_option.hpp"
#include "exchange/convert.hpp"
#include "repair_options.hpp"

namespace foramen::app {
namespace {

struct ConvertCommand {
  ConvertRequest request;
  Console console;
};

// The command in the form in which models record it.
std::string recorded_command(const ConvertRequest& request) {
  std::string command = "foramen convert " + request.input.lexically_normal().filename().string();
  if (request.scale == ScaleMode::remove) command += " --scale remove";
  return command;
}

nlohmann::ordered_json as_json(const ConvertRequest& request, const ConvertSummary& summary) {
  return {{"output", request.output.string()},
          {"files", summary.files},
          {"shapes", summary.shapes},
          {"landmarks", summary.landmarks},
          {"notes", texts_of(summary.notes)}};
}

int convert_files(ConvertCommand command) {
  ConvertRequest& request = command.request;
  request.command = recorded_command(request);
  const ConvertSummary summary = convert(request, command.console.context());
  for (const Message& note : summary.notes) command.console.warn(note);
  if (command.console.json)
    std::cout << as_json(request, summary).dump(2) << '\n';
  else
    command.console.say("wrote " + request.output.string() + ": " + std::to_string(summary.shapes) +
                        " shapes, " + std::to_string(summary.landmarks) + " landmarks, " +
                        std::to_string(summary.files) + (summary.files == 1 ? " file" : " files"));
  return ExitCode::done;
}

constexpr const char* examples = R"(Examples:
  foramen convert model -o model.h5.json                  for Scalismo
  foramen convert model -o study/model.swproj             for ShapeWorks: with study/groomed and study/particles
  foramen convert model -o landmarks.tps                  for R: geomorph::readland.tps("landmarks.tps", specID = "ID")
  foramen convert meshes/ -o model.h5                     a model of any tool's corresponding meshes
  foramen convert study.swproj -o landmarks.csv
  foramen convert landmarks.tps -o meshes --triangles model/mean.ply
Lengths are in mm and axes LPS in all that is written.)";

}  // namespace

void add_convert(CLI::App& program, Run& run) {
  auto options = std::make_shared<ConvertCommand>();
  ConvertRequest& request = options->request;
  CLI::App* command =
      program.add_subcommand("convert", "models and corresponding shapes to and from other tools' files");
  command->footer(examples);
  command
      ->add_option("input", request.input,
                   "a model's folder, model.h5 or .h5.json, a folder of corresponding meshes, a ShapeWorks "
                   "project (.swproj, .xlsx), .tps, or a landmark table (.csv)")
      ->required();
  command
      ->add_option("-o,--output", request.output,
                   "file to write, its kind by its extension: .h5 .h5.json .swproj .tps .csv; or a folder of "
                   "meshes")
      ->required();
  detail::add_field(*command, "--to", request.format,
                    {.meaning = "what to write, where the extension does not say it: scores (.csv); "
                                "ply, vtp, landmarks (of Scalismo): folders"});
  add_unit_option(*command, request.unit);
  command->add_option("--triangles", request.triangles,
                      "a mesh whose vertices the points are, for inputs without triangles");
  add_choice<ScaleMode>(*command, "--scale", request.scale,
                        {{"keep", ScaleMode::keep}, {"remove", ScaleMode::remove}},
                        "keep or remove the shapes' size, where a model is made of shapes");
  add_console_options(*command, options->console);
  command->callback([options, &run] { run = [options] { return convert_files(*options); }; });
}

}  // namespace foramen::app
