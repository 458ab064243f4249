#include "extract/extract_labels.hpp"

#include <algorithm>
#include <set>
#include <utility>
#include <variant>

#include "core/parallel.hpp"
#include "foramen/core/error.hpp"

namespace foramen {
namespace {

// The labels of a map by what is done with them.
struct Plan {
  std::vector<int> wanted;  // wanted labels that the map contains
  std::vector<int> missing_singles, missing_of_ranges, unnamed;
};

Plan plan_for(const std::map<int, LabelExtent>& present, const LabelRequest& request) {
  Plan plan;
  for (const auto& [label, extent] : present) {
    const bool named = request.names.contains(label);
    if (request.labels ? request.labels->contains(label) : named)
      plan.wanted.push_back(label);
    else if (!request.labels)
      plan.unnamed.push_back(label);
  }
  if (!request.labels) return plan;
  for (const LabelSelection::Range& range : request.labels->ranges())
    for (int label = range.first; label <= range.last; ++label)
      if (!present.contains(label))
        (request.labels->named_singly(label) ? plan.missing_singles : plan.missing_of_ranges)
            .push_back(label);
  for (auto* list : {&plan.missing_singles, &plan.missing_of_ranges}) {
    std::sort(list->begin(), list->end());
    list->erase(std::unique(list->begin(), list->end()), list->end());
  }
  return plan;
}

std::string labels_in(const std::map<int, LabelExtent>& present) {
  std::vector<int> labels;
  for (const auto& [label, extent] : present) labels.push_back(label);
  return listed(labels);
}

std::string plural(std::size_t count, const char* one, const char* many) { return count == 1 ? one : many; }

Message none_wanted(const std::map<int, LabelExtent>& present, const LabelRequest& request) {
  if (present.empty()) return {"holds no label: every voxel is 0; give the label map, not the image"};
  const std::string found = "it holds " + labels_in(present);
  if (request.labels)
    return {"holds none of the labels " + request.labels->text() + "; " + found + ": choose among them",
            {{RemedyKind::choose_labels}}};
  return {"holds no label that has a name; " + found + ": choose among them, or say what they are",
          {{RemedyKind::choose_labels}, {RemedyKind::name_labels}}};
}

// What became of voxels that a user may miss.
void note_changes(const LabelSurface& surface, std::vector<Message>& notes) {
  const ExtractionReport& s = surface.extracted.report;
  constexpr double worth_saying = 0.001;
  const auto all = static_cast<double>(s.voxels + s.lost_voxels);
  if (static_cast<double>(s.lost_voxels) > worth_saying * all)
    notes.push_back(surface.stem + ": the largest of " + std::to_string(s.components) +
                    " pieces was taken, " + std::to_string(s.lost_voxels) + " voxels of the others left out");
  if (static_cast<double>(s.filled_voxels) > worth_saying * all)
    notes.push_back(surface.stem + ": cavities of " + std::to_string(s.filled_voxels) +
                    " voxels were filled");
  for (const std::string& side : s.cut_at)
    notes.push_back(surface.stem + ": is cut off at the " + side + " border of the label map");
}

}  // namespace

LabelSurfaces extract_labels(const std::filesystem::path& file, const LabelRequest& request,
                             const RunContext& ctx) {
  const LabelMap map = read_label_map(file);
  ctx.check();
  const auto present = find_labels(map);
  const Plan plan = plan_for(present, request);
  const std::string name = file.filename().string();
  if (plan.wanted.empty()) throw InvalidInput(none_wanted(present, request).about(file.string()));

  const auto stem_of = [&](int label) { return label_map_stem(file) + "_" + name_of(request.names, label); };
  std::set<std::string> stems;
  for (const int label : plan.wanted)
    if (!stems.insert(stem_of(label)).second)
      throw InvalidInput(file.string() + ": two labels would be named " + stem_of(label) +
                             ": rename one in the file that names them",
                         {{RemedyKind::rename_labels}});

  LabelSurfaces result;
  result.sha256 = map.sha256;
  for (const Message& note : map.notes) result.notes.push_back(note.about(name));
  std::vector<std::variant<std::monostate, ExtractedSurface, Message>> outcomes(plan.wanted.size());
  parallel_for(static_cast<int>(plan.wanted.size()), ctx, [&](int i) {
    const std::size_t at = i;
    const int label = plan.wanted[at];
    try {
      outcomes[at] = extract_label(map, label, present.at(label), request.surface);
    } catch (const InvalidInput& e) {
      outcomes[at] = message_of(e);
    }
  });
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const int label = plan.wanted[i];
    if (auto* extracted = std::get_if<ExtractedSurface>(&outcomes[i])) {
      result.surfaces.push_back(
          {label, name_of(request.names, label), stem_of(label), std::move(*extracted)});
      note_changes(result.surfaces.back(), result.notes);
    } else {
      result.refused.push_back({label, name_of(request.names, label), stem_of(label),
                                std::get<Message>(std::move(outcomes[i])), false});
    }
  }
  for (const int label : plan.missing_singles)
    result.refused.push_back({label, name_of(request.names, label), stem_of(label),
                              Message("the label map has no such label; it holds " + labels_in(present),
                                      {{RemedyKind::choose_labels}}),
                              true});
  std::sort(result.refused.begin(), result.refused.end(),
            [](const RefusedLabel& a, const RefusedLabel& b) { return a.label < b.label; });
  if (!plan.missing_of_ranges.empty())
    result.notes.push_back(name + ": has no " + plural(plan.missing_of_ranges.size(), "label ", "labels ") +
                           listed(plan.missing_of_ranges) + " of those asked for");
  if (!plan.unnamed.empty())
    result.notes.push_back({name + ": " + plural(plan.unnamed.size(), "label ", "labels ") +
                                listed(plan.unnamed) + plural(plan.unnamed.size(), " has", " have") +
                                " no name and " + plural(plan.unnamed.size(), "was", "were") +
                                " not taken: choose among them, or say what they are",
                            {{RemedyKind::choose_labels}, {RemedyKind::name_labels}}});
  return result;
}

}  // namespace foramen
