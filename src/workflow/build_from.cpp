#include "workflow/build_from.hpp"

#include <algorithm>
#include <utility>

namespace foramen {
namespace {

InputShape& input_named(std::vector<InputShape>& inputs, const std::string& name) {
  const auto found =
      std::find_if(inputs.begin(), inputs.end(), [&](const InputShape& input) { return input.stem == name; });
  FORAMEN_ASSERT(found != inputs.end());
  return *found;
}

// The name of the reference shape, which may be given as a file name.
std::string stem_of_reference(const std::vector<InputShape>& inputs, const std::string& reference) {
  for (const InputShape& input : inputs)
    if (source_of(input) == reference) return input.stem;
  return reference;
}

BuiltModel built_of(const Cohort& cohort, const BuildOptions& options, const RunContext& ctx) {
  try {
    return build_model(surfaces_of(cohort.shapes), options, ctx);
  } catch (const TooFewShapes& e) {
    Message message = message_of(e);
    for (const LeftOut& shape : cohort.left_out)
      message.append(shape.reason.about("\n  left out " + source_of(shape)));
    throw TooFewShapes(message);
  }
}

}  // namespace

std::vector<Shape> surfaces_of(const std::vector<InputShape>& inputs) {
  std::vector<Shape> shapes;
  for (const InputShape& input : inputs) shapes.push_back({input.stem, input.mesh});
  return shapes;
}

BuildRecord build_from(Cohort cohort, BuildOptions options, const RunContext& ctx) {
  std::string& reference = options.correspondence.reference;
  reference = stem_of_reference(cohort.shapes, reference);
  BuildRecord record;
  record.built = built_of(cohort, options, ctx);
  record.left_out = std::move(cohort.left_out);
  record.notes = std::move(cohort.notes);
  const CohortRegistration& registration = record.built.registration;
  for (const FailedShape& shape : registration.refused_references)
    record.notes.push_back(
        shape.reason.about(source_of(input_named(cohort.shapes, shape.name)) + " cannot be the reference"));
  for (const FailedShape& shape : registration.failed) {
    const InputShape& input = input_named(cohort.shapes, shape.name);
    record.left_out.push_back({input.stem, input.file_name, input.sha256, shape.reason, input.label});
  }
  for (const ShapeRegistration& shape : registration.shapes)
    record.inputs.push_back(std::move(input_named(cohort.shapes, shape.name)));
  return record;
}

}  // namespace foramen
