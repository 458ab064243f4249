#include <algorithm>
#include <filesystem>

#include "command.hpp"
#include "foramen/core/error.hpp"
#include "foramen/io/atomic_file.hpp"
#include "foramen/pipeline/corresponding_folder.hpp"
#include "foramen/pipeline/model_folder.hpp"
#include "foramen/pipeline/model_page.hpp"
#include "foramen/pipeline/model_pictures.hpp"
#include "foramen/pipeline/read_cohort.hpp"
#include "foramen/render/render_scene.hpp"
#include "foramen/spatial/flips.hpp"

namespace foramen::app {
namespace {

namespace fs = std::filesystem;

struct PictureCommand {
  std::string model, output, baseline, shapes;
  bool plain = false;
  Console console;
};

// The shape on which the baseline has the most flipped triangles, in both models.
ReportPicture baseline_flips(const PictureCommand& command) {
  const CorrespondingFolder ours = read_corresponding(fs::path(command.model) / "corresponding");
  const CorrespondingFolder theirs = read_corresponding(fs::path(command.baseline) / "corresponding");
  std::string shape;
  FlippedMesh worst, beside;
  for (const fs::path& file : find_meshes({command.shapes})) {
    const auto find = [&](const CorrespondingFolder& folder) {
      return std::find(folder.names.begin(), folder.names.end(), file.stem().string()) - folder.names.begin();
    };
    const auto i = static_cast<std::size_t>(find(ours)), k = static_cast<std::size_t>(find(theirs));
    if (i == ours.names.size() || k == theirs.names.size()) continue;
    const TriangleTree input(read_shape(file, LengthUnit::millimetre, RepairOptions()).mesh);
    const auto with_flips = [&](const CorrespondingFolder& folder, std::size_t index) {
      FlippedMesh mesh{{folder.shapes[index], folder.triangles}, {}};
      const Mesh corresponding = build_mesh(mesh.soup);
      for (FaceId f : sampled_flips(corresponding, input, {single_precision_height(corresponding)}).plain)
        mesh.flipped.push_back(f.index);
      return mesh;
    };
    FlippedMesh bad = with_flips(theirs, k);
    if (shape.empty() || bad.flipped.size() > worst.flipped.size()) {
      shape = file.stem().string();
      worst = std::move(bad);
      beside = with_flips(ours, i);
    }
  }
  if (shape.empty())
    throw InvalidInput(command.shapes + ": none of these surfaces is a shape of both models");
  return flips_picture(shape, worst, beside);
}

int render(const PictureCommand& command) {
  if (!can_render())
    throw Error(
        "pictures need VTK in the build and a display: install libvtk9-dev, build again, and run under "
        "xvfb-run -a");
  const fs::path folder = command.output;
  fs::create_directories(folder);
  std::vector<std::pair<std::string, ReportPicture>> pictures;
  const auto standard =
      model_pictures(read_atlas(fs::path(command.model) / "atlas.h5"), load_model(command.model).model);
  for (std::size_t i = 0; i < standard.size(); ++i)
    pictures.emplace_back(i == 0   ? "loops.png"
                          : i == 1 ? "torus_map.png"
                                   : "mode" + std::to_string(i - 1) + ".png",
                          standard[i]);
  if (!command.baseline.empty()) pictures.emplace_back("flips.png", baseline_flips(command));
  for (const auto& [name, picture] : pictures) {
    write_file(folder / name, picture.png);
    command.console.say((folder / name).string() + ": " + picture.caption);
  }
  return ExitCode::done;
}

int report(const PictureCommand& command) {
  const fs::path file =
      command.output.empty() ? fs::path(command.model) / "report.html" : fs::path(command.output);
  PageOptions options{.baseline = command.baseline};
  if (command.plain) options.kind = PageKind::plain;
  const ModelPage page = model_page(command.model, options);
  write_file(file, page.html);
  command.console.say(file.string() + ": " + page.remark);
  return ExitCode::done;
}

}  // namespace

void add_render(CLI::App& program, Run& run) {
  auto options = std::make_shared<PictureCommand>();
  CLI::App* command = program.add_subcommand(
      "render",
      "pictures of a model: loops, torus map, modes, flips (under xvfb-run where there is no display)");
  command->footer("Example:\n  xvfb-run -a foramen render model -o pictures");
  command->add_option("model", options->model, "folder of a model")->required();
  command->add_option("-o,--output", options->output, "folder to write")->required();
  auto* baseline = command->add_option("--baseline", options->baseline,
                                       "another model: flipped triangles of both side by side");
  auto* shapes =
      command->add_option("--shapes", options->shapes, "folder of the input surfaces, for the flips");
  baseline->needs(shapes);
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
