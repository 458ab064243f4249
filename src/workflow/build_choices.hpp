#pragma once
/// \file
/// The options that a user sets for a build, and their translation into the options of all stages.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "foramen/core/options.hpp"
#include "foramen/correspond/registration_options.hpp"
#include "foramen/evaluate/evaluate.hpp"
#include "foramen/parameterize/torus_map.hpp"
#include "foramen/stages/build_model.hpp"

namespace foramen {

/// The term that attracts the maps to each other, as a user chooses it.
enum class ObjectiveChoice {
  surface,     ///< Objective::surface
  neighbours,  ///< Objective::neighbours
  description  ///< Objective::surface, followed by rounds that minimise the description length
};
template <>
struct EnumWords<ObjectiveChoice> {
  static constexpr std::pair<std::string_view, ObjectiveChoice> all[] = {
      {"surface", ObjectiveChoice::surface},
      {"neighbours", ObjectiveChoice::neighbours},
      {"description", ObjectiveChoice::description}};
};

/// The text of a choice, which is the text of the option that it sets.
OptionText choice_text(std::string_view name);

/// A choice that is unset means the default of the stages, or the paper's choice if `paper` is set.
struct BuildChoices {
  std::optional<Method> method = std::nullopt;
  std::optional<ObjectiveChoice> objective = std::nullopt;
  std::optional<int> rounds = std::nullopt;
  std::optional<DistortionMeasure> distortion = std::nullopt;
  std::optional<Bending> bending = std::nullopt;
  std::optional<std::string> reference = std::nullopt;
  std::optional<double> lambda = std::nullopt;  ///< for the objective in use, in its unit
  std::optional<int> landmarks = std::nullopt;
  std::optional<double> target_error_mm = std::nullopt;
  std::optional<int> samples = std::nullopt;
  std::optional<std::uint64_t> seed = std::nullopt;  ///< of all stages
  std::optional<ScaleMode> scale = std::nullopt;     ///< in all stages
  std::optional<LandmarkWeights> weights = std::nullopt;
  std::optional<std::string> subject_regex = std::nullopt;  ///< see subject_of()
  bool paper = false;
  std::optional<InitialMap> initial_map = std::nullopt;
  std::optional<Optimiser> optimiser = std::nullopt;
};
template <class Visitor>
void describe(Visitor& visit, MaybeConst<BuildChoices> auto& c) {
  visit(c.method, choice_text("method"));
  visit(c.objective, choice_text("objective"));
  visit(c.rounds, choice_text("rounds"));
  visit(c.distortion, choice_text("distortion"));
  visit(c.bending, choice_text("bending"));
  visit(c.reference, choice_text("reference"));
  visit(c.lambda, choice_text("lambda"));
  visit(c.landmarks, choice_text("landmarks"));
  visit(c.target_error_mm, choice_text("target_error"));
  visit(c.samples, choice_text("samples"));
  visit(c.seed, choice_text("seed"));
  visit(c.scale, choice_text("scale"));
  visit(c.weights, choice_text("weights"));
  visit(c.subject_regex, choice_text("subject_regex"));
  visit(c.paper, choice_text("paper"));
  visit(c.initial_map, choice_text("initial_map"));
  visit(c.optimiser, choice_text("optimiser"));
}

/// The values of choices that are unset. `lambda`, `target_error_mm` and `subject_regex` are unset.
BuildChoices default_choices();

/// The error for a choice that has no effect because of another choice.
class ChoiceWithoutEffect : public InvalidInput {
 public:
  ChoiceWithoutEffect(std::string_view name, const std::string& reason);
  const std::string& name() const { return name_; }  ///< the name of the choice in its description

 private:
  std::string name_;
};

/// The options of all stages for these choices. `paper` sets the paper's choices; a choice that is set
/// explicitly overrides them. Throws InvalidInput for a number out of its range, and ChoiceWithoutEffect.
BuildOptions build_options(const BuildChoices& choices);
EvaluationOptions evaluation_options(const BuildChoices& choices);

}  // namespace foramen
