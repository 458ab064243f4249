#pragma once
/// \file
/// What a user can do about a finding, as a value: a message says it in words, and each front end (the
/// program, Python) names its own control for it.

#include <string>
#include <vector>

namespace foramen {

enum class RemedyKind {
  give_unit,         ///< Say in which unit the input is; the value is that unit, or empty if it is not known.
  leave_unit_out,    ///< Name no unit: the input is in mm.
  extract_surfaces,  ///< Make meshes of the label map first.
  repair,            ///< Have the surface repaired.
  handle_limit,      ///< Raise the length up to which a handle is noise.
  choose_labels,     ///< Name other labels of the label map.
  name_labels,       ///< Say which vertebra a label is.
  rename_labels,     ///< Correct the user's own names of labels.
  keep_cut,          ///< Take labels that reach the border of the label map.
  more_landmarks,    ///< Allow more landmarks.
  subject_pattern,   ///< Correct the regular expression that finds the subject in a name.
  give_truth,        ///< Give the true correspondence.
  give_triangles,    ///< Give a mesh whose vertices the points are.
  leave_triangles_out,  ///< Give no such mesh: the input has triangles.
  choose_format,        ///< Name the format to write; the value is that format.
  another_output,       ///< Give another place to write to.
  build_model,          ///< Build the model.
  evaluate_model,       ///< Evaluate the model and keep the measures.
  only_curves           ///< Do without pictures.
};

struct Remedy {
  RemedyKind kind = RemedyKind::give_unit;
  std::string value = {};  ///< what to give, where one is known to be right
  friend bool operator==(const Remedy&, const Remedy&) = default;
};

/// A finding and what to do about it, in sentences that name no control of any front end, and the remedies
/// for which a front end may have one.
struct Message {
  Message() = default;
  Message(std::string words, std::vector<Remedy> with = {});
  /// The message after the name of what it is about: "L1.ply: " and the text.
  Message about(const std::string& name) const { return {name + ": " + text, remedies}; }
  /// Adds the text of another message, and those of its remedies that are not there yet.
  void append(const Message& more);

  std::string text;
  std::vector<Remedy> remedies;
};

std::vector<std::string> texts_of(const std::vector<Message>& messages);

/// The text, and in parentheses after it what a front end calls its controls for the remedies.
std::string worded(const Message& message, std::string (*name_of)(const Remedy& remedy));

}  // namespace foramen
