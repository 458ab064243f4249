#include "build_options.hpp"

#include "described_option.hpp"

namespace foramen::app {
namespace {

constexpr int description_rounds = 3;

}  // namespace

void BuildFlags::add_to(CLI::App& command) {
  add_described(command, "--method", correspondence, "method");
  objective_option = add_choice<ObjectiveChoice>(
      command, "--objective", objective,
      {{"surface", ObjectiveChoice::surface},
       {"neighbours", ObjectiveChoice::neighbours},
       {"description", ObjectiveChoice::description}},
      "what draws the maps together: points of the bent mean's surface, the paper's soft neighbours, or the "
      "surface and then the description length");
  group_options = {add_described(command, "--rounds", correspondence, "group.rounds"),
                   add_described(command, "--distortion", correspondence, "group.distortion"),
                   add_described(command, "--bending", correspondence, "group.bending")};
  add_described(command, "--reference", correspondence, "reference");
  lambda_option = add_described(command, "--lambda", overrides, "lambda")->default_str("the objective's own");
  CLI::Option* count = add_described(command, "--landmarks", landmarks, "landmarks");
  add_described(command, "--target-error", landmarks, "target_error")->excludes(count);
  add_described(command, "--samples", evaluation, "draws");
  add_described(command, "--seed", evaluation, "seed");
  add_described(command, "--scale", evaluation, "scale");
  add_described(command, "--weights", evaluation, "landmark_weights");
  command.add_option("--subject-regex", subject_pattern,
                     "the part of a file name that names its subject (first group, or all)");
  command.add_flag("--paper", paper, "the paper's own choices throughout");
  map_option = add_described(command, "--initial-map", overrides, "initial_map");
  optimiser_option = add_described(command, "--optimiser", overrides, "optimiser");
}

BuildOptions BuildFlags::resolved() const {
  BuildOptions options{correspondence, landmarks, {evaluation.scale, evaluation.weights}};
  options.landmarks.scale = evaluation.scale;
  options.landmarks.seed = evaluation.seed;
  CorrespondOptions& how = options.correspondence;
  if (paper) {
    how.registration = paper_options();
    how.objective = Objective::neighbours;
  }
  if (objective_option->count() > 0) {
    how.objective = objective == ObjectiveChoice::neighbours ? Objective::neighbours : Objective::surface;
    if (objective == ObjectiveChoice::description) how.group.description_rounds = description_rounds;
  }
  // The two weights have different units, so only that of the objective in use is meant.
  if (lambda_option->count() > 0)
    (registered_together(how) ? how.group.lambda : how.registration.lambda) = overrides.lambda;
  if (map_option->count() > 0) how.registration.initial_map = how.group.initial_map = overrides.initial_map;
  if (optimiser_option->count() > 0) how.registration.optimiser = overrides.optimiser;
  if (!registered_together(how))
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
  command.add_option(
      "--store", store,
      "folder that keeps finished stages after success too; other builds, also at the same time, "
      "take up what they have in common");
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
  request.store = store;
  request.subject_pattern = flags.subject_pattern;
  request.canonical_command = canonical_command;
  return request;
}

}  // namespace foramen::app
