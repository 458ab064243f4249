#include <algorithm>
#include <cmath>

#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include "bindings.hpp"
#include "foramen/core/error.hpp"
#include "foramen/core/rng.hpp"
#include "modelfiles/model_folder.hpp"

namespace foramen::python {
namespace {

using ScoreArray = py::array_t<double, py::array::c_style | py::array::forcecast>;

PointArray as_points(const Eigen::VectorXd& shape) { return points_array(unflattened(shape)); }

// (count, P, 3), to be filled.
py::array_t<double> unfilled_shapes(const LoadedModel& loaded, py::ssize_t count) {
  return py::array_t<double>({count, static_cast<py::ssize_t>(loaded.model.landmarks()), py::ssize_t{3}});
}

// The shapes (N, P, 3) with these scores (N, up to K). Scores in Python are in standard deviations, those of
// foramen in mm. Scores of further modes are 0.
py::array_t<double> reconstruct(const LoadedModel& loaded, const ScoreArray& scores) {
  if (scores.ndim() != 2) throw InvalidInput("scores must be an array of shape (K,) or (N, K)");
  const py::ssize_t count = scores.shape(0), given = scores.shape(1);
  if (given > loaded.model.modes())
    throw InvalidInput("scores: " + std::to_string(given) + " are given, the model has " +
                       std::to_string(loaded.model.modes()) + " modes");
  const double* const from = scores.data();
  if (!std::all_of(from, from + count * given, [](double score) { return std::isfinite(score); }))
    throw InvalidInput("scores: not all are finite; correct them");
  py::array_t<double> out = unfilled_shapes(loaded, count);
  double* const values = out.mutable_data();
  const py::gil_scoped_release unlocked;
  const Eigen::Index size = loaded.model.mean().size();
  for (py::ssize_t i = 0; i < count; ++i) {
    Eigen::VectorXd mm = Eigen::VectorXd::Zero(loaded.model.modes());
    mm.head(given) = Eigen::Map<const Eigen::VectorXd>(from + i * given, given)
                         .cwiseProduct(loaded.model.variance().head(given).cwiseSqrt());
    Eigen::Map<Eigen::VectorXd>(values + i * size, size) = loaded.model.reconstruct(mm);
  }
  return out;
}

Eigen::VectorXd scores_of(const LoadedModel& loaded, const PointArray& points) {
  const auto soup = soup_of(points, TriangleArray(std::vector<py::ssize_t>{0, 3}));
  if (static_cast<int>(soup.points.size()) != loaded.model.landmarks())
    throw InvalidInput("points: " + std::to_string(soup.points.size()) + " are given, the model has " +
                       std::to_string(loaded.model.landmarks()) + " landmarks");
  return loaded.model.scores(flattened(soup.points), loaded.model.modes())
      .cwiseQuotient(loaded.model.variance().cwiseSqrt());
}

// Random shapes, equal to those that `foramen sample` writes for the same seed.
py::array_t<double> sample(const LoadedModel& loaded, int count, std::uint64_t seed) {
  if (count < 0) throw InvalidInput("count is " + std::to_string(count) + "; it must be >= 0");
  const Eigen::Index size = loaded.model.mean().size();
  py::array_t<double> out = unfilled_shapes(loaded, count);
  double* const values = out.mutable_data();
  const py::gil_scoped_release unlocked;
  const Rng root(seed);
  for (int i = 0; i < count; ++i) {
    Rng rng = root.fork(static_cast<std::uint64_t>(i));
    Eigen::Map<Eigen::VectorXd>(values + i * size, size) = loaded.model.reconstruct(loaded.model.draw(rng));
  }
  return out;
}

PointArray along_mode(const LoadedModel& loaded, int mode, double sd) {
  if (mode < 0 || mode >= loaded.model.modes())
    throw InvalidInput("mode is " + std::to_string(mode) + "; the model has " +
                       std::to_string(loaded.model.modes()) + ", counted from 0");
  return as_points(loaded.model.along_mode(mode, sd));
}

// The modes as an array (P, 3, K).
py::array_t<double> basis(const LoadedModel& loaded) {
  const Eigen::MatrixXd& b = loaded.model.basis();
  py::array_t<double> out(
      {static_cast<py::ssize_t>(b.rows() / 3), py::ssize_t{3}, static_cast<py::ssize_t>(b.cols())});
  auto view = out.mutable_unchecked<3>();
  for (py::ssize_t p = 0; p < view.shape(0); ++p)
    for (py::ssize_t k = 0; k < 3; ++k)
      for (py::ssize_t m = 0; m < view.shape(2); ++m) view(p, k, m) = b(3 * p + k, m);
  return out;
}

}  // namespace

void add_models(py::module_& module) {
  py::class_<LoadedModel>(module, "LoadedModel")
      .def(py::init([](const std::string& path) { return load_model(path); }))
      .def_property_readonly("mean", [](const LoadedModel& m) { return as_points(m.model.mean()); })
      .def_property_readonly("triangles",
                             [](const LoadedModel& m) { return triangles_array(m.model.triangles()); })
      .def_property_readonly("variance",
                             [](const LoadedModel& m) { return Eigen::VectorXd(m.model.variance()); })
      .def_property_readonly("basis", &basis)
      .def_property_readonly("weights",
                             [](const LoadedModel& m) {
                               std::vector<double> all = m.model.weights();
                               all.resize(m.model.landmarks(), 1);
                               return py::array_t<double>(static_cast<py::ssize_t>(all.size()), all.data());
                             })
      .def_property_readonly("names", [](const LoadedModel& m) { return m.names; })
      .def_property_readonly("scores",
                             [](const LoadedModel& m) { return Eigen::MatrixXd(m.scores.transpose()); })
      .def_property_readonly("space", [](const LoadedModel& m) { return name_of(m.space); })
      .def("reconstruct", &reconstruct)
      .def("scores_of", &scores_of)
      .def("sample", &sample)
      .def("along_mode", &along_mode);
}

}  // namespace foramen::python
