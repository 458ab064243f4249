#include "build_options.hpp"

namespace foramen::app {
namespace {

constexpr int description_rounds = 3;

}  // namespace

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

void BuildArguments::add_to(CLI::App& command) {
  flags.add_to(command);
  add_unit_option(command, unit);
  label_flags.add_to(command);
  CLI::Option* repair_option =
      command.add_flag("--repair", repair, "repair what cannot be used as it is (see foramen repair)");
  for (CLI::Option* option : add_repair_options(command, repair_options)) option->needs(repair_option);
  command
      .add_option("--truth", truth,
                  "folder of the true correspondence, by the same names: measures the landmarks by it")
      ->check(CLI::ExistingDirectory);
  command.add_flag("--refit", refit,
                   "generalization with the correspondence computed anew without each shape (and each "
                   "subject): as many more builds as there are shapes (and subjects)");
  command.add_flag("--resume", resume,
                   "go on with an interrupted build into the same folder: what it had finished is taken up "
                   "if inputs, options and program are the same");
}

BuildRequest BuildArguments::request(const std::vector<std::string>& inputs, const std::string& output,
                                     const std::string& canonical_command) const {
  BuildRequest request;
  for (const std::string& input : inputs) request.inputs.emplace_back(input);
  request.output = output;
  request.unit = unit;
  request.labels = label_flags.resolved();
  request.truth = truth;
  if (repair) request.repair = repair_options;
  request.build = flags.resolved();
  request.evaluation = flags.evaluation;
  request.refit = refit;
  request.resume = resume;
  request.subject_pattern = flags.subject_pattern;
  request.canonical_command = canonical_command;
  return request;
}

}  // namespace foramen::app
