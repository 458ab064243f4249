#include "remedy_words.hpp"

namespace foramen::app {
namespace {

std::string flag_for(const Remedy& remedy) {
  switch (remedy.kind) {
    case RemedyKind::give_unit:
      return remedy.value.empty() ? "--units" : "--units " + remedy.value;
    case RemedyKind::leave_unit_out:
      return "without --units";
    case RemedyKind::extract_surfaces:
      return "run `foramen extract` first";
    case RemedyKind::repair:
      return "run `foramen repair`, or build with --repair";
    case RemedyKind::handle_limit:
      return "--handle-limit";
    case RemedyKind::choose_labels:
      return "--labels";
    case RemedyKind::name_labels:
      return "--numbering or --label-names";
    case RemedyKind::rename_labels:
      return "--label-names";
    case RemedyKind::keep_cut:
      return "--keep-cut";
    case RemedyKind::more_landmarks:
      return "--landmarks";
    case RemedyKind::subject_pattern:
      return "--subject-regex";
    case RemedyKind::give_truth:
      return "--truth";
    case RemedyKind::give_triangles:
      return "--triangles";
    case RemedyKind::leave_triangles_out:
      return "without --triangles";
    case RemedyKind::choose_format:
      return "--to " + remedy.value;
    case RemedyKind::another_output:
      return "-o";
    case RemedyKind::build_model:
      return "`foramen build`";
    case RemedyKind::evaluate_model:
      return "`foramen evaluate -o`";
    case RemedyKind::only_curves:
      return "--only-curves";
  }
  throw InternalError("a remedy without a flag");
}

}  // namespace

std::string worded(const Message& message) { return foramen::worded(message, flag_for); }
std::string worded(const std::exception& error) { return worded(message_of(error)); }

}  // namespace foramen::app
