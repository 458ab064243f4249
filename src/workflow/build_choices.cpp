#include "workflow/build_choices.hpp"

#include <array>

#include "foramen/core/error.hpp"
#include "foramen/correspond/registration_options.hpp"

namespace foramen {
namespace {

constexpr int description_rounds = 3;

// The text of the option with this path, from the description of its struct.
template <DescribedOptions Options>
OptionText text_of(std::string_view path) {
  Options options;
  std::optional<OptionText> found;
  for_each_option(options, [&](const std::string& at, const auto&, const OptionText& text) {
    if (at == path) found = text;
  });
  FORAMEN_ASSERT(found.has_value());
  return *found;
}

OptionText text_behind(std::string_view name) {
  if (name == "method" || name == "reference") return text_of<CorrespondOptions>(name);
  if (name == "objective")
    return {.meaning =
                "what draws the maps together: points of the bent mean's surface, the paper's soft "
                "neighbours, or the surface and then the description length"};
  if (name == "rounds" || name == "distortion" || name == "bending")
    return text_of<RegisterGroupOptions>(name);
  if (name == "lambda" || name == "initial_map" || name == "optimiser") return text_of<RegisterOptions>(name);
  if (name == "landmarks" || name == "target_error") return text_of<PlaceLandmarksOptions>(name);
  if (name == "samples") return text_of<EvaluationOptions>("draws");
  if (name == "seed" || name == "scale") return text_of<EvaluationOptions>(name);
  if (name == "weights") return text_of<EvaluationOptions>("landmark_weights");
  if (name == "subject_regex")
    return {.meaning = "the part of a file name that names its subject (first group, or all)"};
  FORAMEN_ASSERT(name == "paper");
  return {.meaning = "the paper's own choices throughout"};
}

// The options of register_group() have an effect only if shapes are registered as a group.
void require_effect(const BuildChoices& choices, const CorrespondOptions& how) {
  if (registered_together(how)) return;
  const std::array<std::pair<const char*, bool>, 3> given = {{{"rounds", choices.rounds.has_value()},
                                                              {"distortion", choices.distortion.has_value()},
                                                              {"bending", choices.bending.has_value()}}};
  for (const auto& [name, is_given] : given)
    if (is_given)
      throw ChoiceWithoutEffect(
          name, "has no effect with the method icp, the objective neighbours or the paper's choices");
}

template <class Field>
void take(Field& field, const std::optional<Field>& choice) {
  if (choice) field = *choice;
}

}  // namespace

OptionText choice_text(std::string_view name) {
  OptionText text = text_behind(name);
  text.name = name;
  return text;
}

BuildChoices default_choices() {
  const CorrespondOptions correspond;
  const EvaluationOptions evaluation;
  return {.method = correspond.method,
          .objective = ObjectiveChoice::surface,
          .rounds = correspond.group.round_limit,
          .distortion = correspond.group.distortion,
          .bending = correspond.group.bending,
          .reference = correspond.reference,
          .landmarks = PlaceLandmarksOptions{}.count,
          .samples = evaluation.draws,
          .seed = evaluation.seed,
          .scale = evaluation.scale,
          .weights = evaluation.weights,
          .initial_map = correspond.registration.initial_map,
          .optimiser = correspond.registration.optimiser};
}

ChoiceWithoutEffect::ChoiceWithoutEffect(std::string_view name, const std::string& reason)
    : InvalidInput(std::string(name) + " " + reason + "; leave it out"), name_(name) {}

BuildOptions build_options(const BuildChoices& choices) {
  check_options("build", choices);
  const EvaluationOptions evaluation = evaluation_options(choices);
  BuildOptions options;
  options.model = {evaluation.scale, evaluation.weights};

  options.landmarks.scale = evaluation.scale;
  options.landmarks.seed = evaluation.seed;
  if (choices.landmarks && choices.target_error_mm)
    throw ChoiceWithoutEffect("landmarks", "has no effect beside target_error, which decides the number");
  take(options.landmarks.count, choices.landmarks);
  options.landmarks.target_error_mm = choices.target_error_mm;

  CorrespondOptions& how = options.correspondence;
  take(how.method, choices.method);
  take(how.reference, choices.reference);
  take(how.group.round_limit, choices.rounds);
  take(how.group.distortion, choices.distortion);
  take(how.group.bending, choices.bending);
  if (choices.paper) {
    how.registration = paper_options();
    how.objective = Objective::neighbours;
  }
  if (choices.objective) {
    how.objective =
        choices.objective == ObjectiveChoice::neighbours ? Objective::neighbours : Objective::surface;
    if (choices.objective == ObjectiveChoice::description) how.group.description_rounds = description_rounds;
  }
  // The weights of the two objectives have different units, so lambda sets only that of the objective in use.
  take(registered_together(how) ? how.group.lambda : how.registration.lambda, choices.lambda);
  take(how.registration.initial_map, choices.initial_map);
  take(how.group.initial_map, choices.initial_map);
  take(how.registration.optimiser, choices.optimiser);
  require_effect(choices, how);
  return options;
}

EvaluationOptions evaluation_options(const BuildChoices& choices) {
  EvaluationOptions options;
  take(options.scale, choices.scale);
  take(options.weights, choices.weights);
  take(options.draws, choices.samples);
  take(options.seed, choices.seed);
  return options;
}

}  // namespace foramen
