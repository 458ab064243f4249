#include "findings/plain_words.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "findings/model_report.hpp"

namespace foramen {
namespace {

constexpr double most_variation = 0.8;  // what the named modes hold together
constexpr double named_sd = 2;          // 95 % of a normal distribution

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

std::string percent(double share) { return fixed(100 * share, 0) + " %"; }

std::size_t subject_count(const Evaluation& evaluation) {
  return std::set<std::string>(evaluation.subjects.begin(), evaluation.subjects.end()).size();
}

Statement what_it_is(const ModelRecord& record) {
  const Evaluation& evaluation = record.evaluation;
  const std::size_t used = evaluation.names.size(), left_out = record.run.shapes.size() - used;
  std::string text =
      "A statistical model of the shape of vertebrae, learnt from " + std::to_string(used) + " vertebrae";
  if (const std::size_t subjects = subject_count(evaluation); subjects > 0)
    text += " of " + counted(subjects, "subject", "subjects");
  text +=
      ". Each is described by the same " + std::to_string(evaluation.landmarks) +
      " landmarks: landmark number 1 is meant to lie at the same place of the anatomy on all of them, and "
      "so on. ";
  text += left_out == 0 ? "No input was left out."
                        : counted(left_out, "input was", "inputs were") + " left out; the reasons are below.";
  return {"What this is", text};
}

// The largest displacement of a landmark [mm] at named_sd standard deviations of a mode.
double reach(const ShapeModel& model, int mode) {
  const auto displacements = unflattened(model.basis().col(mode) * std::sqrt(model.variance()[mode]));
  double largest = 0;
  for (const Vec3& d : displacements) largest = std::max(largest, d.norm());
  return named_sd * largest;
}

Statement how_they_differ(const ModelRecord& record) {
  const ShapeModel& model = record.loaded.model;
  const double total = model.variance().sum();
  int named = 0;
  for (double sum = 0; named < model.modes() && sum < most_variation * total;)
    sum += model.variance()[named++];
  std::string text = "By " + counted(static_cast<std::size_t>(model.modes()), "pattern", "patterns") +
                     ", called modes, the strongest first. ";
  if (model.modes() > 0)
    text +=
        "Mode 1 holds " + percent(model.variance()[0] / total) +
        " of all variation and moves landmarks by up to " + fixed(reach(model, 0), 1) +
        " mm over the range of ±2 standard deviations, which 95 % of normally distributed shapes lie in. ";
  if (named > 1)
    text += "The first " + std::to_string(named) + " together hold " +
            percent(model.variance().head(named).sum() / total) + ". ";
  text += record.run.options.scale() == ScaleMode::keep
              ? "Size counts as a part of shape."
              : "All shapes were brought to one size first: the model does not know size.";
  return {"How the shapes differ", text};
}

Statement how_exact(const ModelRecord& record) {
  const Evaluation& evaluation = record.evaluation;
  const Representation& r = evaluation.representation;
  std::string text = "The landmarks reproduce the surfaces they stand for to " +
                     fixed(r.mean_surface.mean, 2) + " mm on average, and to " + fixed(r.hausdorff.mean, 2) +
                     " mm at the worst place of a shape. ";
  if (const ErrorsAtModes* g = at_quoted_modes(evaluation.leave_one_out.by_modes))
    text += "A shape that was kept out of the model is reproduced by " +
            counted(static_cast<std::size_t>(g->modes), "mode", "modes") + " to " +
            fixed(g->mean_surface, 2) + " mm on average and to " + fixed(g->hausdorff, 1) +
            " mm at its worst place (± standard error over the shapes).";
  return {"How exact it is", text};
}

std::string about_flips(const ModelRecord& record) {
  const Evaluation& evaluation = record.evaluation;
  int in_maps = 0, sampled = 0;
  bool maps = true;
  for (const RunShape& shape : record.run.shapes)
    if (shape.used) {
      maps = maps && shape.used->flips_in_map.has_value();
      in_maps += shape.used->flips_in_map.value_or(0);
    }
  for (const ShapeRepresentation& r : evaluation.representation.shapes) sampled += r.confirmed_flips;
  const std::size_t triangles = evaluation.names.size() * record.loaded.model.triangles().size();
  const std::string of = std::to_string(sampled) + " of " + std::to_string(triangles);
  std::string text;
  if (maps)
    text =
        in_maps == 0
            ? "Every shape is matched to the others one to one: no triangle of any map is turned over, "
              "which was checked by exact arithmetic. "
            : std::to_string(in_maps) + " triangles of the maps are turned over: there the match is wrong. ";
  else
    text = "The shapes were matched by closest points, which promises no one-to-one match. ";
  if (sampled > 0)
    text += of + " triangles between landmarks are turned over on their shape; they are marked in the view. ";
  else if (!maps)
    text += "No triangle between landmarks is turned over. ";
  return text;
}

Statement how_far_to_trust(const ModelRecord& record) {
  const Evaluation& evaluation = record.evaluation;
  std::string text = about_flips(record);
  const double impossible = evaluation.drawn.self_intersecting.mean;
  text +=
      (impossible == 0   ? std::string("None")
       : impossible == 1 ? std::string("All")
                         : fixed(100 * impossible, 1) + " %") +
      " of " + std::to_string(evaluation.options.draws) +
      " random shapes of the model (all scores within ±2 standard deviations) intersect themselves, which "
      "no vertebra does. ";
  const std::size_t subjects = subject_count(evaluation);
  text += counted(evaluation.names.size(), "shape", "shapes") +
          (subjects > 0 ? " of " + counted(subjects, "subject", "subjects") : "") +
          " are a sample: what none of them has, the model does not know. It is made for research, not for "
          "diagnosis.";
  return {"How far to trust it", text};
}

}  // namespace

std::vector<Statement> in_plain_words(const ModelRecord& record) {
  return {what_it_is(record), how_they_differ(record), how_exact(record), how_far_to_trust(record)};
}

}  // namespace foramen
