#include "extract/name_labels.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "extract/numbering_fit.hpp"
#include "extract/vertebra_level.hpp"

namespace foramen {
namespace {

const Remedy say_what_they_are{RemedyKind::name_labels};

std::string quoted(const std::string& text) { return "'" + text + "'"; }

// The names that the file gives to labels which are there: the vertebrae, or everything if no name is a
// level.
LabelNames names_in_file(const LabelMap& layer, const std::map<int, LabelExtent>& present) {
  LabelNames levels, all;
  for (const auto& [label, name] : layer.names) {
    if (!present.contains(label)) continue;
    all[label] = name_for_files(name);
    if (auto level = level_of(name)) levels[label] = *std::move(level);
  }
  return levels.empty() ? all : levels;
}

std::string words_for(const std::vector<LabelNumbering>& numberings, const LabelHeights& labels) {
  std::string text;
  for (const LabelNumbering numbering : numberings)
    text += (text.empty() ? "" : " or ") + std::string(word_of(numbering)) + " (" +
            meaning_of(labels, numbering) + ")";
  return text;
}

class Namer {
 public:
  Namer(const LabelMap& layer, const std::map<int, LabelExtent>& present, const std::string& stem,
        const LabelRequest& request)
      : layer_(layer),
        present_(present),
        stem_(stem),
        request_(request),
        numbering_(request.numbering.value_or(LabelNumbering::verse)),
        in_file_(names_in_file(layer, present)) {
    if (present.size() == 1) level_in_name_ = level_in_file_name(stem);
  }

  LabelNaming result() {
    choose();
    doubt_against_names_in_file();
    doubt_against_level_in_name();
    const bool by_numbers = naming_.source == NameSource::numbering || naming_.source == NameSource::assumed;
    if (by_numbers && !named_label1_) doubt_the_numbering();
    return std::move(naming_);
  }

 private:
  void take(LabelNames names, NameSource source) {
    naming_.names = std::move(names);
    naming_.source = source;
  }

  bool known(int label) const { return label_names(numbering_).contains(label); }

  void choose() {
    const int only = present_.size() == 1 ? present_.begin()->first : 0;
    if (request_.names) return take(*request_.names, NameSource::label_names);
    // "Segment_1" in a file vertebrae_L1 tells less than the file's name.
    const bool levels_in_file = std::any_of(in_file_.begin(), in_file_.end(), [](const auto& entry) {
      return rank_of_level(entry.second).has_value();
    });
    const bool is_mask = level_in_name_ && (only == 1 || !known(only));
    if (!request_.numbering && !in_file_.empty() && (levels_in_file || !is_mask))
      return take(in_file_, NameSource::names_in_file);
    if (is_mask) return take({{only, level_in_name_->level}}, NameSource::file_name);
    take(label_names(numbering_), request_.numbering ? NameSource::numbering : NameSource::assumed);
    if (only != 1 || request_.numbering) return;
    named_label1_ = true;
    naming_.names = {{only, "label1"}};
    naming_.doubts.emplace_back(
        "its only label is 1, which VerSe would call C1, but a mask of any one structure has this label and "
        "the file's name has no level; it is called label1: say what it is",
        std::vector{say_what_they_are});
  }

  // What the user or the numbering says against what the file calls its labels.
  void doubt_against_names_in_file() {
    if (naming_.source == NameSource::names_in_file) return;
    std::string differences;
    for (const auto& [label, name] : in_file_) {
      const auto chosen = naming_.names.find(label);
      if (!rank_of_level(name) || chosen == naming_.names.end() || !rank_of_level(chosen->second) ||
          chosen->second == name)
        continue;
      differences += (differences.empty() ? "" : ", ") + std::string("label ") + std::to_string(label) +
                     " is " + chosen->second + " by " + naming_.origin(request_) + " and " +
                     quoted(layer_.names.at(label)) + " in the file";
    }
    if (!differences.empty())
      naming_.doubts.emplace_back(
          differences + ": the former is taken; leave it out to take the names in the file",
          std::vector{say_what_they_are});
  }

  void doubt_against_level_in_name() {
    if (!level_in_name_) return;
    const int label = present_.begin()->first;
    const std::string& level = level_in_name_->level;
    const auto chosen = naming_.names.find(label);
    const auto contradiction = [&](const std::string& name, const std::string& by, const char* taken) {
      naming_.doubts.emplace_back("label " + std::to_string(label) + " is " + name + " by " + by +
                                      ", but the file's name says " + level + "; " + taken +
                                      " is taken: say what it is",
                                  std::vector{say_what_they_are});
    };
    if (naming_.source == NameSource::file_name) {
      if (request_.numbering && known(label) && name_of(label_names(numbering_), label) != level)
        contradiction(name_of(label_names(numbering_), label), std::string(word_of(numbering_)),
                      "the file's name");
    } else if (chosen != naming_.names.end() && rank_of_level(chosen->second) && chosen->second != level) {
      contradiction(chosen->second, naming_.origin(request_), "the former");
    }
  }

  void doubt_the_numbering() {
    const LabelHeights labels = heights_of(layer_, present_);
    const auto taken = [&] {
      const std::string meaning = meaning_of(labels, numbering_);
      return naming_.origin(request_) +
             (meaning.empty() ? ", which names none of them" : " (" + meaning + "), which is taken");
    };
    if (const auto better = better_numberings(labels, numbering_); !better.empty()) {
      naming_.doubts.emplace_back("its labels fit the numbering " + words_for(better, labels) +
                                      " better than " + taken() + ": say which it is",
                                  std::vector{say_what_they_are});
      return;
    }
    const auto region = region_in_file_name(stem_);
    if (!region || any_in_region(labels, *region, numbering_)) return;
    const auto others = numberings_in_region(labels, *region, numbering_);
    naming_.doubts.emplace_back(
        "the file's name tells a part of the spine (" + std::string(1, *region) +
            ") in which no label is by " + taken() +
            (others.empty() ? "" : "; they would be by " + words_for(others, labels)) + ": say which it is",
        std::vector{say_what_they_are});
  }

  const LabelMap& layer_;
  const std::map<int, LabelExtent>& present_;
  const std::string& stem_;
  const LabelRequest& request_;
  const LabelNumbering numbering_;
  const LabelNames in_file_;
  std::optional<LevelInName> level_in_name_;
  LabelNaming naming_;
  bool named_label1_ = false;
};

}  // namespace

std::string LabelNaming::origin(const LabelRequest& request) const {
  switch (source) {
    case NameSource::label_names:
      return "the names given";
    case NameSource::names_in_file:
      return "the names in the file";
    case NameSource::file_name:
      return "the file's name";
    case NameSource::numbering:
      return std::string(word_of(request.numbering.value_or(LabelNumbering::verse)));
    default:
      return std::string(word_of(LabelNumbering::verse)) + ", assumed";
  }
}

LabelNaming name_labels(const LabelMap& layer, const std::map<int, LabelExtent>& present,
                        const std::string& stem, const LabelRequest& request) {
  return Namer(layer, present, stem, request).result();
}

}  // namespace foramen
