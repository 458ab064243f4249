#include "build_options.hpp"
#include "foramen/core/error.hpp"
#include "foramen/pipeline/run_build.hpp"
#include "label_options.hpp"
#include "repair_options.hpp"

namespace foramen::app {
namespace {

namespace fs = std::filesystem;

constexpr int description_rounds = 3;

struct BuildCommand {
  BuildFlags flags;
  BuildOptions build;  // as the flags have it
  LabelFlags label_flags;
  std::optional<LabelRequest> labels;  // the same
  std::vector<std::string> inputs;
  std::string output;
  std::string truth;
  LengthUnit unit = LengthUnit::millimetre;
  bool refit = false, resume = false, strict = false, repair = false;
  RepairOptions repair_options;
  Console console;
};

int build(const BuildCommand& command) {
  BuildRequest request;
  for (const std::string& input : command.inputs) request.inputs.emplace_back(input);
  request.output = command.output;
  request.unit = command.unit;
  request.labels = command.labels;
  request.truth = command.truth;
  if (command.repair) request.repair = command.repair_options;
  request.build = command.build;
  request.evaluation = command.flags.evaluation;
  request.refit = command.refit;
  request.resume = command.resume;
  request.subject_pattern = command.flags.subject_pattern;
  request.canonical_command = command.console.command;
  try {
    return finish_build(request, command.console, command.strict);
  } catch (const Cancelled&) {
    command.console.warn("the same command with --resume goes on from here");
    throw;
  }
}

}  // namespace

std::string canonical_command(const CLI::App& command, const std::vector<std::string>& inputs) {
  static const std::vector<std::string> without{"--output", "--truth",  "--threads", "--resume", "--json",
                                                "--quiet",  "--events", "--log",     "inputs",   "--help"};
  std::string text = "foramen " + command.get_name();
  for (const std::string& input : inputs)
    text += " " + fs::path(input).lexically_normal().filename().string();
  for (const CLI::Option* option : command.get_options()) {
    const std::string name = option->get_single_name();
    const std::string shown = option->get_lnames().empty() ? name : "--" + option->get_lnames().front();
    if (option->count() == 0 || std::find(without.begin(), without.end(), shown) != without.end()) continue;
    text += " " + shown;
    if (option->get_expected_max() > 0)  // no flag
      for (const std::string& value : option->results())
        text += " " + (shown == "--label-names" ? fs::path(value).filename().string() : value);
  }
  return text;
}

void BuildFlags::add_to(CLI::App& command) {
  add_choice<Method>(command, "--method", build.method, {{"torus", Method::torus}, {"icp", Method::icp}},
                     "torus maps, or the ICP baseline");
  objective_option = add_choice<ObjectiveChoice>(
      command, "--objective", objective,
      {{"surface", ObjectiveChoice::surface},
       {"neighbours", ObjectiveChoice::neighbours},
       {"description", ObjectiveChoice::description}},
      "what draws the maps together: points of the bent mean's surface, the paper's soft neighbours, or the "
      "surface and then the description length");
  group_options = {
      command
          .add_option("--rounds", build.group.round_limit,
                      "most rounds with the mean as template; 0: the reference stays the template")
          ->check(CLI::Range(0, 100)),
      add_choice<DistortionMeasure>(
          command, "--distortion", build.group.distortion,
          {{"template", DistortionMeasure::on_template}, {"plane", DistortionMeasure::in_plane}},
          "where distortion is measured: on the template, or in the flat torus"),
      add_choice<Bending>(
          command, "--bending", build.group.bending,
          {{"cohort", Bending::cohort}, {"smooth", Bending::smooth}, {"rigid", Bending::rigid}},
          "how the template is brought onto a shape: bent, with what the other shapes tell or each by "
          "itself, or only aligned")};
  command.add_option("--reference", build.reference, "name of the reference shape, or auto");
  lambda_option =
      command
          .add_option("--lambda", lambda,
                      "weight of distortion against correspondence (default: the objective's own)")
          ->check(CLI::PositiveNumber)
          ->default_str("");
  auto* count =
      command.add_option("--landmarks", build.landmarks, "number of landmarks (refinement may add 5 %)")
          ->check(CLI::Range(50, 200000));
  command
      .add_option("--target-error", build.target_error_mm,
                  "as few landmarks as represent the shapes this well [mm]")
      ->check(CLI::PositiveNumber)
      ->excludes(count);
  command
      .add_option("--samples", evaluation.draws, "random shapes for specificity, and for their own quality")
      ->check(CLI::Range(1, 1000000));
  command.add_option("--seed", build.seed, "seed of all random numbers");
  add_choice<ScaleMode>(command, "--scale", build.scale,
                        {{"keep", ScaleMode::keep}, {"remove", ScaleMode::remove}},
                        "keep or remove the shapes' size");
  add_choice<LandmarkWeights>(command, "--weights", build.weights,
                              {{"equal", LandmarkWeights::equal}, {"area", LandmarkWeights::area}},
                              "what landmarks count for: all alike, or by their area");
  command.add_option("--subject-regex", subject_pattern,
                     "the part of a file name that names its subject (first group, or all)");
  command.add_flag("--paper", paper, "the paper's own choices throughout");
  map_option = add_choice<InitialMap>(command, "--initial-map", initial_map,
                                      {{"torus", InitialMap::torus}, {"rectangle", InitialMap::rectangle}},
                                      "first map of a shape");
  optimiser_option =
      add_choice<Optimiser>(command, "--optimiser", optimiser,
                            {{"newton", Optimiser::newton}, {"polak-ribiere", Optimiser::polak_ribiere}},
                            "projected Newton, or the paper's node-wise descent");
}

BuildOptions BuildFlags::resolved() const {
  BuildOptions options = build;
  if (paper) {
    options.registration = paper_options();
    options.objective = Objective::neighbours;
  }
  if (objective_option->count() > 0) {
    options.objective = objective == ObjectiveChoice::neighbours ? Objective::neighbours : Objective::surface;
    if (objective == ObjectiveChoice::description) options.group.description_rounds = description_rounds;
  }
  if (lambda_option->count() > 0) options.registration.lambda = options.group.lambda = lambda;
  if (map_option->count() > 0) options.registration.initial_map = options.group.initial_map = initial_map;
  if (optimiser_option->count() > 0) options.registration.optimiser = optimiser;
  if (!registered_together(options))
    for (const CLI::Option* option : group_options)
      if (option->count() > 0)
        throw CLI::ValidationError(
            option->get_name(),
            "has no effect with --method icp, --objective neighbours or --paper; leave it out");
  return options;
}

int finish_build(const BuildRequest& request, const Console& console, bool strict) {
  const BuildSummary summary = run_build(request, console.context());
  for (const LeftOut& shape : summary.left_out)
    console.warn("left out " + source_of(shape) + ": " + shape.reason);
  for (const std::string& note : summary.notes) console.warn(note);
  if (console.json)
    std::cout << summary.json << '\n';
  else
    console.say(summary.text);
  return strict && !summary.left_out.empty() ? ExitCode::refused : ExitCode::done;
}

void add_build(CLI::App& program, Run& run) {
  auto options = std::make_shared<BuildCommand>();
  CLI::App* command = program.add_subcommand(
      "build", "a statistical shape model from surfaces or label maps, with its evaluation and report");
  command->footer(
      "Examples:\n  foramen build shapes/ -o model\n  foramen build spine.nii.gz --labels 20-24 -o model     "
      " (a label map: L1 to L5)\n  foramen build shapes/ --repair --subject-regex '^([^_]+)' -o model");
  command->add_option("inputs", options->inputs, "mesh files, label maps, or folders of them")->required();
  command->add_option("-o,--output", options->output, "folder of the model")->required();
  options->flags.add_to(*command);
  add_unit_option(*command, options->unit);
  options->label_flags.add_to(*command);
  CLI::Option* repair = command->add_flag("--repair", options->repair,
                                          "repair what cannot be used as it is (see foramen repair)");
  for (CLI::Option* option : add_repair_options(*command, options->repair_options)) option->needs(repair);
  command
      ->add_option("--truth", options->truth,
                   "folder of the true correspondence, by the same names: measures the landmarks by it")
      ->check(CLI::ExistingDirectory);
  command->add_flag("--refit", options->refit,
                    "generalization with the correspondence computed anew without each shape (and each "
                    "subject): as many more builds as there are shapes (and subjects)");
  command->add_flag("--resume", options->resume,
                    "go on with an interrupted build into the same folder: what it had finished is taken up "
                    "if inputs, options and program are the same");
  command->add_flag("--strict", options->strict, "exit 1 if any shape is left out");
  add_console_options(*command, options->console);
  command->callback([options, command, &run] {
    options->build = options->flags.resolved();
    options->labels = options->label_flags.resolved();
    options->console.command = canonical_command(*command, options->inputs);
    run = [options] { return build(*options); };
  });
}

}  // namespace foramen::app
