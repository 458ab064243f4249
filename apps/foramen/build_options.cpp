#include "build_options.hpp"

#include "described_option.hpp"

namespace foramen::app {

void BuildFlags::add_to(CLI::App& command) {
  const auto added = add_choices(command, choices, default_choices());
  added.at("lambda")->default_str("the objective's own");
  added.at("target_error")->excludes(added.at("landmarks"));
}

BuildOptions BuildFlags::resolved() const {
  try {
    return build_options(choices);
  } catch (const ChoiceWithoutEffect& e) {
    throw CLI::ValidationError(
        flag_of(e.name()),
        "has no effect with --method icp, --objective neighbours or --paper; leave it out");
  }
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
  request.evaluation = evaluation_options(flags.choices);
  request.refit = refit;
  request.resume = resume;
  request.store = store;
  request.subject_pattern = flags.choices.subject_regex.value_or("");
  request.canonical_command = canonical_command;
  return request;
}

}  // namespace foramen::app
