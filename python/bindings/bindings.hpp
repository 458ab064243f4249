#pragma once
/// \file
/// Declarations that the parts of the Python module share. Arrays are C-contiguous numpy arrays; lengths are
/// in mm.

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <nlohmann/json.hpp>

#include "foramen/core/mesh.hpp"
#include "foramen/core/run_context.hpp"
#include "foramen/core/shape.hpp"
#include "foramen/core/units.hpp"
#include "foramen/correspond/correspond.hpp"
#include "foramen/io/mesh_file.hpp"

namespace foramen::python {

namespace py = pybind11;

using PointArray = py::array_t<double, py::array::c_style | py::array::forcecast>;
using TriangleArray = py::array_t<int, py::array::c_style | py::array::forcecast>;

/// Convert (P, 3) and (T, 3) arrays to a soup, and a soup to arrays. Throw InvalidInput for arrays of another
/// shape.
TriangleSoup soup_of(const PointArray& points, const TriangleArray& triangles);
PointArray points_array(std::span<const Vec3> points);
TriangleArray triangles_array(const std::vector<std::array<int, 3>>& triangles);

/// Convert "LPS" and "RAS" to a space, and a space to text.
AnatomicalSpace space_of(const std::string& name);
std::string name_of(AnatomicalSpace space);

/// input_unit() of the unit with this name. Throws InvalidInput if there is none.
InputUnit unit_named(const std::optional<std::string>& name);

/// The value as JSON text for Python's json.loads. File names may contain bytes that are invalid in UTF-8.
std::string text_of(const nlohmann::ordered_json& value);

/// Runs work without holding the interpreter's lock. `progress` is None or a callable, which is called with
/// stage, fraction and item under the lock. An exception that it raises, or Ctrl-C, ends the work and is
/// raised again.
void run_unlocked(int threads, const py::object& progress,
                  const std::function<void(const RunContext&)>& work);

/// Convert shapes with the same number of points to an array (N, P, 3), and such an array to shapes. Throw
/// InvalidInput for arrays of another shape.
py::array_t<double> shapes_array(const std::vector<std::vector<Vec3>>& shapes);
std::vector<std::vector<Vec3>> shapes_of(const PointArray& points);

/// Surfaces from Python: those that passed the audit of a build's input, and those that did not.
struct GivenShapes {
  std::vector<Shape> shapes;
  std::vector<AnatomicalSpace> spaces;  ///< one per shape
  std::vector<FailedShape> refused;
};

void add_errors(py::module_& module);
void add_options(py::module_& module);
void add_meshes(py::module_& module);
void add_models(py::module_& module);
/// \pre add_models()
void add_model_uses(py::module_& module);
/// \pre add_model_uses()
void add_stages(py::module_& module);
/// \pre add_stages()
void add_evaluation(py::module_& module);
void add_runs(py::module_& module);

}  // namespace foramen::python
