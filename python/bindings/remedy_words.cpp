#include "remedy_words.hpp"

#include <pybind11/pybind11.h>

#include "foramen/core/error.hpp"

namespace foramen::python {
namespace {

std::string keyword_for(const Remedy& remedy) {
  switch (remedy.kind) {
    case RemedyKind::give_unit:
      return (remedy.value.empty() ? "units" : "units='" + remedy.value + "'") + " of files; a Mesh is in mm";
    case RemedyKind::leave_unit_out:
      return "without units";
    case RemedyKind::extract_surfaces:
      return "foramen.extract()";
    case RemedyKind::repair:
      return "foramen.repair(), or repair=True";
    case RemedyKind::handle_limit:
      return "handle_limit";
    case RemedyKind::choose_labels:
      return "labels";
    case RemedyKind::name_labels:
      return "numbering or label_names";
    case RemedyKind::rename_labels:
      return "label_names";
    case RemedyKind::keep_cut:
      return "keep_cut=True";
    case RemedyKind::more_landmarks:
      return "landmarks";
    case RemedyKind::subject_pattern:
      return "subject_regex";
    case RemedyKind::give_truth:
      return "truth";
    case RemedyKind::give_triangles:
      return "triangles";
    case RemedyKind::leave_triangles_out:
      return "without triangles";
    case RemedyKind::choose_format:
      return "to='" + remedy.value + "'";
    case RemedyKind::another_output:
      return "output";
    case RemedyKind::build_model:
      return "foramen.build()";
    case RemedyKind::evaluate_model:
      return "foramen.evaluate()";
    case RemedyKind::only_curves:
      return "only_curves=True";
  }
  throw InternalError("a remedy without a keyword");
}

}  // namespace

std::string worded(const Message& message) { return foramen::worded(message, keyword_for); }

void warn(const std::vector<Message>& notes) {
  constexpr int callers_caller = 2;  // the line that called the function of the package
  for (const Message& note : notes)
    if (PyErr_WarnEx(PyExc_UserWarning, worded(note).c_str(), callers_caller) != 0)
      throw pybind11::error_already_set();
}

}  // namespace foramen::python
