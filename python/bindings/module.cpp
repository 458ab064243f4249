#include <chrono>
#include <future>
#include <thread>

#include "bindings.hpp"
#include "foramen/core/error.hpp"
#include "modelfiles/version.hpp"
#include "remedy_words.hpp"

namespace foramen::python {

TriangleSoup soup_of(const PointArray& points, const TriangleArray& triangles) {
  if (points.ndim() != 2 || points.shape(1) != 3)
    throw InvalidInput("points must be an array of shape (P, 3)");
  if (triangles.ndim() != 2 || triangles.shape(1) != 3)
    throw InvalidInput("triangles must be an array of shape (T, 3)");
  TriangleSoup soup;
  const auto p = points.unchecked<2>();
  for (py::ssize_t i = 0; i < p.shape(0); ++i) soup.points.emplace_back(p(i, 0), p(i, 1), p(i, 2));
  const auto t = triangles.unchecked<2>();
  for (py::ssize_t i = 0; i < t.shape(0); ++i) soup.triangles.push_back({t(i, 0), t(i, 1), t(i, 2)});
  return soup;
}

PointArray points_array(std::span<const Vec3> points) {
  PointArray out({static_cast<py::ssize_t>(points.size()), py::ssize_t{3}});
  auto view = out.mutable_unchecked<2>();
  for (std::size_t i = 0; i < points.size(); ++i)
    for (int k = 0; k < 3; ++k) view(static_cast<py::ssize_t>(i), k) = points[i][k];
  return out;
}

TriangleArray triangles_array(const std::vector<std::array<int, 3>>& triangles) {
  TriangleArray out({static_cast<py::ssize_t>(triangles.size()), py::ssize_t{3}});
  auto view = out.mutable_unchecked<2>();
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      view(static_cast<py::ssize_t>(i), static_cast<py::ssize_t>(k)) = triangles[i][k];
  return out;
}

py::array_t<double> shapes_array(const std::vector<std::vector<Vec3>>& shapes) {
  const std::size_t points = shapes.empty() ? 0 : shapes.front().size();
  py::array_t<double> out(
      {static_cast<py::ssize_t>(shapes.size()), static_cast<py::ssize_t>(points), py::ssize_t{3}});
  double* value = out.mutable_data();
  for (const auto& shape : shapes) {
    FORAMEN_ASSERT(shape.size() == points);
    for (const Vec3& p : shape) value = std::copy(p.begin(), p.end(), value);
  }
  return out;
}

std::vector<std::vector<Vec3>> shapes_of(const PointArray& points) {
  if (points.ndim() != 3 || points.shape(2) != 3)
    throw InvalidInput("points must be an array of shape (N, P, 3)");
  std::vector<std::vector<Vec3>> shapes(points.shape(0));
  const double* value = points.data();
  for (auto& shape : shapes) {
    shape.resize(points.shape(1));
    for (Vec3& p : shape) {
      p = Eigen::Map<const Vec3>(value);
      value += 3;
    }
  }
  return shapes;
}

InputUnit unit_named(const std::optional<std::string>& name) {
  if (!name) return {};
  const auto unit = length_unit(*name);
  if (!unit) throw InvalidInput("units must be mm, cm, m or um, not " + *name);
  return input_unit(unit);
}

AnatomicalSpace space_of(const std::string& name) {
  if (name == "LPS") return AnatomicalSpace::lps;
  if (name == "RAS") return AnatomicalSpace::ras;
  throw InvalidInput("space must be LPS or RAS, not " + name);
}

std::string name_of(AnatomicalSpace space) { return space == AnatomicalSpace::lps ? "LPS" : "RAS"; }

std::string text_of(const nlohmann::ordered_json& value) {
  return value.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

namespace {

// The interval at which the interpreter is asked whether the user has pressed Ctrl-C.
constexpr std::chrono::milliseconds between_signals(50);

// Does the work on a thread of its own, and calls look() at regular intervals until it is done. Throws what
// the work throws.
void run_beside(const std::function<void()>& work, const std::function<void()>& look) {
  std::packaged_task<void()> task(work);
  std::future<void> done = task.get_future();
  std::thread worker(std::move(task));
  while (done.wait_for(between_signals) != std::future_status::ready) look();
  worker.join();
  done.get();
}

}  // namespace

void run_unlocked(int threads, const py::object& progress,
                  const std::function<void(const RunContext&)>& work) {
  std::exception_ptr raised;  // exception of the callback or of Ctrl-C; accessed under the interpreter's lock
  const RunContext* running = nullptr;
  // Makes a call that may raise a Python exception. Such an exception ends the work.
  const auto stopping = [&](const auto& call) {
    const py::gil_scoped_acquire lock;
    if (raised) return;
    try {
      call();
    } catch (...) {
      raised = std::current_exception();
      running->request_stop();
    }
  };
  const auto report = [&](const Progress& p) {
    stopping([&] {
      if (!progress.is_none()) progress(p.stage, p.fraction, p.item);
    });
  };
  // Python handles signals only on its main thread, which waits here while other threads work.
  const auto look_for_signals = [&] {
    stopping([] {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    });
  };
  const RunContext ctx(threads, report);
  running = &ctx;
  std::exception_ptr failed;
  {
    const py::gil_scoped_release unlocked;
    try {
      run_beside([&] { work(ctx); }, look_for_signals);
    } catch (...) {
      failed = std::current_exception();
    }
  }
  if (raised) std::rethrow_exception(raised);
  if (failed) std::rethrow_exception(failed);
}

void add_errors(py::module_& module) {
  const auto base = py::register_exception<Error>(module, "Error");
  py::register_exception<Cancelled>(module, "Cancelled", base);
  py::register_exception<ConvergenceError>(module, "ConvergenceError", base);
  py::register_exception<IoError>(module, "IoError", base);
  const auto invalid = py::register_exception<InvalidInput>(module, "InvalidInput", base);
  py::register_exception<TopologyError>(module, "TopologyError", invalid);
  // Asked before the others: an error with remedies goes on to them with the keywords in its text.
  py::register_exception_translator([](std::exception_ptr error) {
    try {
      std::rethrow_exception(std::move(error));
    } catch (const Cancelled&) {
      throw;
    } catch (const TopologyError& e) {
      throw TopologyError(worded(message_of(e)));
    } catch (const InvalidInput& e) {
      throw InvalidInput(worded(message_of(e)));
    } catch (const IoError& e) {
      throw IoError(worded(message_of(e)));
    } catch (const ConvergenceError& e) {
      throw ConvergenceError(worded(message_of(e)));
    } catch (const Error& e) {
      throw Error(worded(message_of(e)));
    }
  });
}

}  // namespace foramen::python

PYBIND11_MODULE(_foramen, module) {
  using namespace foramen;
  module.attr("version") = version();
  python::add_errors(module);
  python::add_meshes(module);
  python::add_models(module);
  python::add_model_uses(module);
  python::add_options(module);
  python::add_stages(module);
  python::add_evaluation(module);
  python::add_runs(module);
}
