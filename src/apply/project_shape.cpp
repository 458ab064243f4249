#include "foramen/apply/project_shape.hpp"

#include <algorithm>
#include <utility>

#include "foramen/core/error.hpp"

namespace foramen {

ProjectedShape project_shape(std::span<const Vec3> landmarks, const AlignedModel& aligned_model,
                             ScaleMode scale) {
  const ShapeModel& model = aligned_model.model;
  if (static_cast<int>(landmarks.size()) != model.landmarks())
    throw InvalidInput("the shape has " + std::to_string(landmarks.size()) + " landmarks, the model " +
                       std::to_string(model.landmarks()) + "; they must be those of the model");
  ProjectedShape result;
  result.to_model = align_to_mean(landmarks, aligned_model.alignment, scale, model.weights());
  std::vector<Vec3> aligned;
  aligned.reserve(landmarks.size());
  for (const Vec3& p : landmarks) aligned.push_back(result.to_model(p));
  const Eigen::VectorXd shape = flattened(aligned);
  const Eigen::VectorXd scores = model.scores(shape, model.modes());
  const Eigen::VectorXd closest = model.reconstruct(scores);
  result.scores = scores.cwiseQuotient(model.variance().cwiseSqrt());
  result.landmark_rms = model.landmark_rms(shape, closest);
  const SimilarityTransform back = result.to_model.inverse();
  for (const Vec3& p : unflattened(closest)) result.fit.push_back(back(p));
  return result;
}

AlignedModel model_without(const AlignedModel& model, std::span<const std::string> names,
                           std::span<const std::string> left_out, ScaleMode scale) {
  const std::vector<std::vector<Vec3>>& shapes = model.alignment.aligned;
  FORAMEN_ASSERT(shapes.size() == names.size());
  for (const std::string& name : left_out)
    if (std::find(names.begin(), names.end(), name) == names.end()) {
      std::string message = "there is no training shape " + name + " to leave out; there are";
      for (const std::string& known : names) message += " " + known;
      throw InvalidInput(message);
    }
  std::vector<std::vector<Vec3>> others;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (std::find(left_out.begin(), left_out.end(), names[i]) == left_out.end()) others.push_back(shapes[i]);
  if (others.size() < 2)
    throw InvalidInput("leaving out " + std::to_string(left_out.size()) + " of " +
                       std::to_string(names.size()) + " training shapes leaves fewer than 2");
  AlignedModel rest;
  rest.alignment = procrustes(others, scale, model.model.weights());
  rest.model = model_of_aligned(rest.alignment.aligned, model.model.triangles(), model.model.weights());
  return rest;
}

}  // namespace foramen
