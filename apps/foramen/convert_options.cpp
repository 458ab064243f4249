#include "convert_options.hpp"

#include <nlohmann/json.hpp>

#include "described_option.hpp"
#include "repair_options.hpp"

namespace foramen::app {

void add_convert_options(CLI::App& command, ConvertRequest& request) {
  detail::add_field(command, "--to", request.format,
                    {.meaning = "what to write, where the extension does not say it: scores (.csv); "
                                "ply, vtp, landmarks (of Scalismo): folders"});
  add_unit_option(command, request.unit);
  command.add_option("--triangles", request.triangles,
                     "a mesh whose vertices the points are, for inputs without triangles");
  add_choice<ScaleMode>(command, "--scale", request.scale,
                        {{"keep", ScaleMode::keep}, {"remove", ScaleMode::remove}},
                        "keep or remove the shapes' size, where a model is made of shapes");
}

std::string recorded_command(const ConvertRequest& request) {
  std::string command = "foramen convert " + request.input.lexically_normal().filename().string();
  if (request.scale == ScaleMode::remove) command += " --scale remove";
  return command;
}

nlohmann::ordered_json convert_json(const ConvertRequest& request, const ConvertSummary& summary) {
  return {{"output", request.output.string()},
          {"files", summary.files},
          {"shapes", summary.shapes},
          {"landmarks", summary.landmarks},
          {"notes", texts_of(summary.notes)}};
}

}  // namespace foramen::app
