#include <filesystem>
#include <iostream>

#include <nlohmann/json.hpp>

#include "command.hpp"
#include "foramen/pipeline/convert.hpp"

namespace foramen::app {
namespace {

struct ConvertCommand {
  ConvertRequest request;
  Console console;
};

int convert_files(ConvertCommand command) {
  ConvertRequest& request = command.request;
  request.command = "foramen convert " + request.input.lexically_normal().filename().string();
  if (request.scale == ScaleMode::remove) request.command += " --scale remove";
  const ConvertSummary summary = convert(request, command.console.context());
  for (const std::string& note : summary.notes) command.console.warn(note);
  if (command.console.json)
    std::cout << nlohmann::ordered_json{{"output", request.output.string()},
                                        {"files", summary.files},
                                        {"shapes", summary.shapes},
                                        {"landmarks", summary.landmarks},
                                        {"notes", summary.notes}}
                     .dump(2)
              << '\n';
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
                   "project (.swproj), .tps, or a landmark table (.csv)")
      ->required();
  command
      ->add_option("-o,--output", request.output,
                   "file to write, its kind by its extension: .h5 .h5.json .swproj .tps .csv; or a folder of "
                   "meshes")
      ->required();
  add_choice<std::optional<ExchangeFormat>>(
      *command, "--to", request.format,
      {{"h5", ExchangeFormat::statismo},
       {"h5.json", ExchangeFormat::scalismo_json},
       {"swproj", ExchangeFormat::shapeworks},
       {"tps", ExchangeFormat::tps},
       {"csv", ExchangeFormat::landmark_table},
       {"scores", ExchangeFormat::score_table},
       {"ply", ExchangeFormat::ply},
       {"vtp", ExchangeFormat::vtp},
       {"landmarks", ExchangeFormat::scalismo_landmarks}},
      "what to write, where the extension does not say it: scores (.csv); "
      "ply, vtp, landmarks (of Scalismo): folders");
  add_choice<LengthUnit>(*command, "--units", request.unit,
                         {{"mm", LengthUnit::millimetre},
                          {"cm", LengthUnit::centimetre},
                          {"m", LengthUnit::metre},
                          {"um", LengthUnit::micrometre}},
                         "of the input's shapes");
  command->add_option("--triangles", request.triangles,
                      "a mesh whose vertices the points are, for inputs without triangles");
  add_choice<ScaleMode>(*command, "--scale", request.scale,
                        {{"keep", ScaleMode::keep}, {"remove", ScaleMode::remove}},
                        "keep or remove the shapes' size, where a model is made of shapes");
  add_console_options(*command, options->console);
  command->callback([options, &run] { run = [options] { return convert_files(*options); }; });
}

}  // namespace foramen::app
