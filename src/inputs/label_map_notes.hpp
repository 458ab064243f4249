#pragma once
/// \file
/// What is said once about all label maps of a cohort.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "extract/extract_labels.hpp"

namespace foramen {

/// Collects what several label maps have in common, so that many files make few notes: masks of which nothing
/// was taken, and numberings that were assumed.
class LabelMapNotes {
 public:
  void add(const std::filesystem::path& file, const LabelSurfaces& labels);
  /// Why nothing was taken of some masks: one note a reason, with the names of the first files.
  std::vector<Message> on_passed_over() const;
  /// These and, if a numbering was assumed, a note on that.
  std::vector<Message> messages() const;

 private:
  std::map<std::string, std::vector<std::string>> passed_over_;  // files by reason
  std::vector<std::string> assumed_;
};

/// The first names of a list and how many more there are: "a, b, c and 9 more".
std::string first_names(const std::vector<std::string>& names);

}  // namespace foramen
