#include "options.hpp"

#include <algorithm>
#include <cctype>
#include <numeric>

#include "extract/extract_labels.hpp"
#include "foramen/apply/complete_surface.hpp"
#include "foramen/evaluate/evaluate.hpp"
#include "foramen/repair/repair_mesh.hpp"
#include "foramen/stages/build_model.hpp"
#include "workflow/build_choices.hpp"

namespace foramen::python {
namespace detail {
namespace {

// The number of similar names that a message suggests for an unknown name.
constexpr std::size_t most_offered = 3;

// The number of letters to insert, remove or replace to turn a into b (Levenshtein distance).
std::size_t edits(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t above = row[j];
      row[j] = std::min({above + 1, row[j - 1] + 1, diagonal + (a[i - 1] == b[j - 1] ? 0 : 1)});
      diagonal = above;
    }
  }
  return row.back();
}

std::string leaf(const std::string& path) { return path.substr(path.rfind('.') + 1); }

std::string joined_by_commas(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::vector<std::string> nearest_paths(const std::string& given, std::vector<std::string> paths) {
  const auto distance = [&](const std::string& path) {
    return std::min(edits(given, path), edits(leaf(given), leaf(path)));
  };
  std::stable_sort(paths.begin(), paths.end(),
                   [&](const std::string& a, const std::string& b) { return distance(a) < distance(b); });
  paths.resize(std::min(paths.size(), most_offered));
  return paths;
}

bool ends_with_parts(const std::string& path, const std::string& given) {
  return path.size() > given.size() && path.ends_with(given) && path[path.size() - given.size() - 1] == '.';
}

// A whole number as Python's int. A bool is not accepted as a number.
py::int_ whole_number(py::handle given, const std::string& option) {
  if (py::isinstance<py::bool_>(given) || PyIndex_Check(given.ptr()) == 0)
    wrong_type(option, "a whole number", given);
  PyObject* const number = PyNumber_Index(given.ptr());
  if (number == nullptr) throw py::error_already_set();
  return py::reinterpret_steal<py::int_>(number);
}

[[noreturn]] void beyond(const std::string& option, const py::int_& number) {
  throw InvalidInput(option + " is " + py::str(py::object(number)).cast<std::string>() +
                     ", which no option can be");
}

}  // namespace

void wrong_type(const std::string& option, const char* what, py::handle given) {
  throw py::type_error(option + " must be " + what + ", not " + Py_TYPE(given.ptr())->tp_name);
}

std::string string_from(py::handle given, const std::string& option) {
  if (py::isinstance<py::str>(given)) return given.cast<std::string>();
  if (py::hasattr(given, "__fspath__")) return py::str(given.attr("__fspath__")()).cast<std::string>();
  wrong_type(option, "a string", given);
}

std::string word_from(py::handle given, const std::string& option) {
  if (!py::isinstance<py::str>(given)) wrong_type(option, "a string or a member of its enumeration", given);
  std::string word = given.cast<std::string>();
  std::transform(word.begin(), word.end(), word.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return word;
}

bool bool_from(py::handle given, const std::string& option) {
  const std::string type = Py_TYPE(given.ptr())->tp_name;
  if (!py::isinstance<py::bool_>(given) && type != "numpy.bool_" && type != "numpy.bool")
    wrong_type(option, "True or False", given);
  return PyObject_IsTrue(given.ptr()) == 1;
}

double number_from(py::handle given, const std::string& option) {
  const bool number = PyFloat_Check(given.ptr()) || PyIndex_Check(given.ptr()) != 0 ||
                      (PyNumber_Check(given.ptr()) != 0 && py::hasattr(given, "__float__"));
  if (py::isinstance<py::bool_>(given) || !number) wrong_type(option, "a number", given);
  const double value = PyFloat_AsDouble(given.ptr());
  if (value == -1 && PyErr_Occurred() != nullptr) throw py::error_already_set();
  return value;
}

std::int64_t integer_from(py::handle given, const std::string& option, std::int64_t least) {
  const py::int_ number = whole_number(given, option);
  int overflow = 0;
  const long long value = PyLong_AsLongLongAndOverflow(number.ptr(), &overflow);
  if (overflow != 0 || value < least || value > std::numeric_limits<int>::max()) beyond(option, number);
  return value;
}

std::uint64_t unsigned_from(py::handle given, const std::string& option) {
  const py::int_ number = whole_number(given, option);
  const unsigned long long value = PyLong_AsUnsignedLongLong(number.ptr());
  if (PyErr_Occurred() != nullptr) {
    PyErr_Clear();
    beyond(option, number);
  }
  return value;
}

bool is_dict(py::handle given) { return py::isinstance<py::dict>(given); }

std::string path_meant(const std::string& given, const std::vector<std::string>& paths) {
  std::vector<std::string> meant;
  for (const std::string& path : paths) {
    if (path == given) return path;
    if (ends_with_parts(path, given)) meant.push_back(path);
  }
  if (meant.size() == 1) return meant.front();
  if (!meant.empty())
    throw InvalidInput(given + " is the name of several options; name one of " + joined_by_commas(meant));
  throw InvalidInput("there is no option " + given + "; the nearest are " +
                     joined_by_commas(nearest_paths(given, paths)));
}

}  // namespace detail

namespace {

// Calls use(options) with the defaults of the options of a function.
template <class Use>
py::object with_options_of(const std::string& function, const Use& use) {
  if (function == "correspond") return use(CorrespondOptions{});
  if (function == "place_landmarks") return use(PlaceLandmarksOptions{});
  if (function == "build_model") return use(BuildOptions{});
  if (function == "evaluate") return use(EvaluationOptions{});
  if (function == "complete") return use(CompleteSurfaceOptions{});
  if (function == "repair") return use(RepairOptions{});
  if (function == "build") return use(default_choices());
  throw InvalidInput(
      "there are options of correspond, place_landmarks, build_model, evaluate, complete, "
      "repair and build, not of " +
      function);
}

py::object list_options(const std::string& function) {
  return with_options_of(function, [](const auto& options) -> py::object { return listed_options(options); });
}

// The values of all options when these options are given.
py::object options_with(const std::string& function, const py::dict& given) {
  return with_options_of(function, [&](auto options) -> py::object {
    set_options(options, given, function.c_str());
    return detail::python_value(options);
  });
}

}  // namespace

void add_options(py::module_& module) {
  module.def("list_options", &list_options);
  module.def("options_with", &options_with);
}

}  // namespace foramen::python
