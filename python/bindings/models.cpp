#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include "bindings.hpp"
#include "foramen/core/error.hpp"
#include "foramen/core/rng.hpp"
#include "foramen/pipeline/model_folder.hpp"

namespace foramen::python {
namespace {

PointArray as_points(const Eigen::VectorXd& shape) { return points_array(unflattened(shape)); }

// In standard deviations, as Python has all scores; foramen's are in mm.
Eigen::VectorXd in_mm(const LoadedModel& loaded, const Eigen::VectorXd& scores) {
  if (scores.size() > loaded.model.modes())
    throw InvalidInput("scores: " + std::to_string(scores.size()) + " are given, the model has " +
                       std::to_string(loaded.model.modes()) + " modes");
  return scores.cwiseProduct(loaded.model.variance().head(scores.size()).cwiseSqrt());
}

PointArray reconstruct(const LoadedModel& loaded, const Eigen::VectorXd& scores) {
  return as_points(loaded.model.reconstruct(in_mm(loaded, scores)));
}

Eigen::VectorXd scores_of(const LoadedModel& loaded, const PointArray& points) {
  const auto soup = soup_of(points, TriangleArray(std::vector<py::ssize_t>{0, 3}));
  if (static_cast<int>(soup.points.size()) != loaded.model.landmarks())
    throw InvalidInput("points: " + std::to_string(soup.points.size()) + " are given, the model has " +
                       std::to_string(loaded.model.landmarks()) + " landmarks");
  return loaded.model.scores(flattened(soup.points), loaded.model.modes())
      .cwiseQuotient(loaded.model.variance().cwiseSqrt());
}

// The shapes that `foramen sample` writes for the same seed.
py::array_t<double> sample(const LoadedModel& loaded, int count, std::uint64_t seed) {
  if (count < 0) throw InvalidInput("count is " + std::to_string(count) + "; it must be >= 0");
  const Eigen::Index size = loaded.model.mean().size();
  py::array_t<double> out(
      {static_cast<py::ssize_t>(count), static_cast<py::ssize_t>(size / 3), py::ssize_t{3}});
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

// (P, 3, K)
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
                               all.resize(static_cast<std::size_t>(m.model.landmarks()), 1);
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
