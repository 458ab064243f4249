#include "extract/extract_labels.hpp"

#include <algorithm>
#include <set>
#include <utility>
#include <variant>

#include "core/parallel.hpp"
#include "extract/numbering_fit.hpp"
#include "extract/vertebra_level.hpp"
#include "foramen/core/error.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;

struct Layer {
  LabelMap map;
  std::map<int, LabelExtent> present;
  LabelNaming naming;
};

// A label of a layer.
struct Place {
  std::size_t layer = 0;
  int label = 0;
  friend bool operator<(const Place& a, const Place& b) {
    return std::pair(a.label, a.layer) < std::pair(b.label, b.layer);
  }
};

// The labels of a file by what is done with them.
struct Plan {
  std::vector<Place> wanted;  // wanted labels that the file contains
  std::vector<int> missing_singles, missing_of_ranges, unnamed;
};

// Of all layers. The extents are those of one of them.
std::map<int, LabelExtent> present_in(const std::vector<Layer>& layers) {
  std::map<int, LabelExtent> present;
  for (const Layer& layer : layers) present.insert(layer.present.begin(), layer.present.end());
  return present;
}

Plan plan_for(const std::vector<Layer>& layers, const LabelRequest& request) {
  Plan plan;
  for (std::size_t l = 0; l < layers.size(); ++l)
    for (const auto& [label, extent] : layers[l].present) {
      const bool named = layers[l].naming.names.contains(label);
      if (request.labels ? request.labels->contains(label) : named)
        plan.wanted.push_back({l, label});
      else if (!request.labels)
        plan.unnamed.push_back(label);
    }
  std::sort(plan.wanted.begin(), plan.wanted.end());
  if (request.labels) {
    const auto present = present_in(layers);
    for (const LabelSelection::Range& range : request.labels->ranges())
      for (int label = range.first; label <= range.last; ++label)
        if (!present.contains(label))
          (request.labels->named_singly(label) ? plan.missing_singles : plan.missing_of_ranges)
              .push_back(label);
  }
  for (auto* list : {&plan.missing_singles, &plan.missing_of_ranges, &plan.unnamed}) {
    std::sort(list->begin(), list->end());
    list->erase(std::unique(list->begin(), list->end()), list->end());
  }
  return plan;
}

// Whether the label of a mask, or the number that its level has in the numbering, is among the labels.
bool selects_mask(const LabelRequest& request, int label, const std::string& level) {
  if (request.labels->contains(label)) return true;
  for (const auto& [number, name] : label_names(request.numbering.value_or(LabelNumbering::verse)))
    if (name == level && request.labels->contains(number)) return true;
  return false;
}

std::string labels_in(const std::map<int, LabelExtent>& present) {
  std::vector<int> labels;
  for (const auto& [label, extent] : present) labels.push_back(label);
  return listed(labels);
}

std::string plural(std::size_t count, const char* one, const char* many) { return count == 1 ? one : many; }

Message none_wanted(const std::vector<Layer>& layers, const LabelRequest& request) {
  const auto present = present_in(layers);
  if (present.empty()) return {"holds no label: every voxel is 0; give the label map, not the image"};
  const std::string found = "it holds " + labels_in(present);
  if (request.labels)
    return {"holds none of the labels " + request.labels->text() + "; " + found + ": choose among them",
            {{RemedyKind::choose_labels}}};
  Message message("holds no label that has a name; " + found + ": choose among them, or say what they are",
                  {{RemedyKind::choose_labels}, {RemedyKind::name_labels}});
  for (const Layer& layer : layers)
    for (const Message& doubt : layer.naming.doubts) message.append({"; " + doubt.text, doubt.remedies});
  return message;
}

Message note_on_unnamed(const std::string& file, const std::vector<Layer>& layers,
                        const std::vector<int>& unnamed) {
  const bool by_file = std::any_of(layers.begin(), layers.end(), [](const Layer& layer) {
    return layer.naming.source == NameSource::names_in_file;
  });
  const bool one = unnamed.size() == 1;
  const std::string finding = by_file ? (one ? " is no vertebra by its name in the file"
                                             : " are no vertebrae by their names in the file")
                                      : (one ? " has no name" : " have no name");
  return {file + ": " + plural(unnamed.size(), "label ", "labels ") + listed(unnamed) + finding + " and " +
              plural(unnamed.size(), "was", "were") + " not taken: choose among them, or say what they are",
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

std::vector<Layer> read_layers(const LabelMapFile& file, const LabelRequest& request) {
  std::vector<Layer> layers;
  for (LabelMap& map : read_label_layers(file.path)) {
    auto present = find_labels(map);
    LabelNaming naming = name_labels(map, present, label_map_stem(file.path), request);
    layers.push_back({std::move(map), std::move(present), std::move(naming)});
  }
  return layers;
}

// Why nothing is taken of a file whose name says that it is the mask of one vertebra; unset for others.
std::optional<std::string> why_passed_over(const LabelMapFile& file, const std::vector<Layer>& layers,
                                           const LabelRequest& request) {
  if (present_in(layers).empty()) {
    if (!level_in_file_name(label_map_stem(file.path))) return std::nullopt;
    return "empty";
  }
  const LabelNaming& naming = layers.front().naming;
  if (naming.source != NameSource::file_name || !request.labels) return std::nullopt;
  const auto& [label, level] = *naming.names.begin();
  if (selects_mask(request, label, level)) return std::nullopt;
  return "of another level than those asked for";
}

}  // namespace

bool is_kind_of_files(const std::string& folder) {
  static const std::set<std::string> kinds{"segmentations", "segmentation", "segs",  "seg",
                                           "masks",         "mask",         "labels"};
  return kinds.contains(folder);
}

std::string patient_folder(const fs::path& file) {
  std::error_code failed;
  fs::path folder = fs::absolute(file, failed).lexically_normal().parent_path();
  while (is_kind_of_files(folder.filename().string())) folder = folder.parent_path();
  return folder.filename().string();
}

LabelMapFile::LabelMapFile(fs::path file) : path(std::move(file)), stem(label_map_stem(path)) {
  const auto found = level_in_file_name(stem);
  mask_stem = found && found->rest.empty() ? patient_folder(path) : found ? found->rest : stem;
}

LabelSurfaces extract_labels(const LabelMapFile& file, const LabelRequest& asked, const RunContext& ctx) {
  const std::vector<Layer> layers = read_layers(file, asked);
  ctx.check();
  const std::string name = file.path.filename().string();
  LabelSurfaces result;
  result.sha256 = layers.front().map.sha256;
  const LabelNaming& first = layers.front().naming;
  result.names_from = first.origin(asked);
  result.passed_over = why_passed_over(file, layers, asked);
  if (result.passed_over) return result;
  const bool mask = first.source == NameSource::file_name;
  LabelRequest request = asked;
  if (mask) request.labels = std::nullopt;

  const Plan plan = plan_for(layers, request);
  if (plan.wanted.empty()) throw InvalidInput(none_wanted(layers, request).about(file.path.string()));
  result.assumed = first.source == NameSource::assumed && first.names == label_names(LabelNumbering::verse);
  const std::string prefix = mask ? (file.mask_stem.empty() ? "" : file.mask_stem + "_") : file.stem + "_";
  const auto label_name = [&](const Place& place) {
    return name_of(layers[place.layer].naming.names, place.label);
  };
  const auto stem_of = [&](const Place& place) { return prefix + label_name(place); };
  std::set<std::string> stems;
  for (const Place& place : plan.wanted)
    if (!stems.insert(stem_of(place)).second)
      throw InvalidInput(file.path.string() + ": two labels would be named " + stem_of(place) +
                             ": rename one in the file that names them",
                         {{RemedyKind::rename_labels}});

  for (const Message& note : layers.front().map.notes) result.notes.push_back(note.about(name));
  std::vector<std::variant<std::monostate, ExtractedSurface, Message>> outcomes(plan.wanted.size());
  parallel_for(static_cast<int>(plan.wanted.size()), ctx, [&](int i) {
    const std::size_t at = i;
    const Place& place = plan.wanted[at];
    const Layer& layer = layers[place.layer];
    try {
      outcomes[at] = extract_label(layer.map, place.label, layer.present.at(place.label), request.surface);
    } catch (const InvalidInput& e) {
      outcomes[at] = message_of(e);
    }
  });
  for (const Layer& layer : layers)
    for (const Message& doubt : layer.naming.doubts) result.notes.push_back(doubt.about(name));
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const Place& place = plan.wanted[i];
    if (auto* extracted = std::get_if<ExtractedSurface>(&outcomes[i])) {
      result.surfaces.push_back({place.label, label_name(place), stem_of(place), std::move(*extracted)});
      note_changes(result.surfaces.back(), result.notes);
    } else {
      result.refused.push_back(
          {place.label, label_name(place), stem_of(place), std::get<Message>(std::move(outcomes[i])), false});
    }
  }
  for (const int label : plan.missing_singles)
    result.refused.push_back(
        {label, label_name({0, label}), stem_of({0, label}),
         Message("the label map has no such label; it holds " + labels_in(present_in(layers)),
                 {{RemedyKind::choose_labels}}),
         true});
  std::stable_sort(result.refused.begin(), result.refused.end(),
                   [](const RefusedLabel& a, const RefusedLabel& b) { return a.label < b.label; });
  if (!plan.missing_of_ranges.empty())
    result.notes.push_back(name + ": has no " + plural(plan.missing_of_ranges.size(), "label ", "labels ") +
                           listed(plan.missing_of_ranges) + " of those asked for");
  if (!plan.unnamed.empty()) result.notes.push_back(note_on_unnamed(name, layers, plan.unnamed));
  return result;
}

}  // namespace foramen
