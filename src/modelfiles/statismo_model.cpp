#include "modelfiles/statismo_model.hpp"

#include "modelfiles/model_folder.hpp"

namespace foramen {

Eigen::MatrixXd scores_of(const ShapeModel& model, const std::vector<Eigen::VectorXd>& shapes) {
  Eigen::MatrixXd scores(model.modes(), std::ssize(shapes));
  for (std::size_t i = 0; i < shapes.size(); ++i)
    scores.col(static_cast<Eigen::Index>(i)) =
        model.scores(shapes[i], model.modes()).cwiseQuotient(model.variance().cwiseSqrt());
  return scores;
}

StatismoModel statismo_model(const ShapeModel& model, const std::vector<Eigen::VectorXd>& aligned,
                             const std::string& command) {
  const ShapeModel plain = model.weights().empty() ? model : reweighted(model, {});
  StatismoModel file;
  file.points = unflattened(plain.mean());
  file.triangles = plain.triangles();
  file.mean = plain.mean();
  file.basis = plain.basis();
  file.variance = plain.variance();
  file.landmark_weights = model.weights();
  file.scores = scores_of(plain, aligned);
  file.build_time = build_time();
  file.parameters = {{"command", command}};
  return file;
}

}  // namespace foramen
