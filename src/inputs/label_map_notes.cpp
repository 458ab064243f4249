#include "inputs/label_map_notes.hpp"

#include <algorithm>

namespace foramen {

std::string first_names(const std::vector<std::string>& names) {
  constexpr std::size_t most = 5;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, names.size()); ++i) text += (i > 0 ? ", " : "") + names[i];
  return names.size() > most ? text + " and " + std::to_string(names.size() - most) + " more" : text;
}

void LabelMapNotes::add(const std::filesystem::path& file, const LabelSurfaces& labels) {
  const std::string name = file.filename().string(), folder = patient_folder(file);
  if (labels.passed_over)
    passed_over_[*labels.passed_over].push_back(folder.empty() ? name : folder + "/" + name);
  else if (labels.assumed)
    assumed_.push_back(name);
}

std::vector<Message> LabelMapNotes::on_passed_over() const {
  std::vector<Message> notes;
  for (const auto& [reason, files] : passed_over_)
    notes.emplace_back((files.size() == 1 ? "1 mask is " + reason + " and was passed over: "
                                          : std::to_string(files.size()) + " masks are " + reason +
                                                " and were passed over: ") +
                       first_names(files));
  return notes;
}

std::vector<Message> LabelMapNotes::messages() const {
  std::vector<Message> notes = on_passed_over();
  if (!assumed_.empty())
    notes.emplace_back(
        "the labels were assumed to be numbered as by VerSe (8 is T1, 20 is L1), because "
        "nothing else is said of " +
            first_names(assumed_) + ": name the numbering to be sure",
        std::vector<Remedy>{{RemedyKind::name_labels}});
  return notes;
}

}  // namespace foramen
