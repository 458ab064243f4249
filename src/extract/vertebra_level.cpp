#include "extract/vertebra_level.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <set>
#include <utility>
#include <vector>

namespace foramen {
namespace {

// A word of a name: letters and digits, in lower case.
struct Word {
  std::size_t begin = 0, end = 0;
  std::string text;
};

std::vector<Word> words_of(std::string_view name) {
  std::vector<Word> words;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const auto c = static_cast<unsigned char>(name[i]);
    if (std::isalnum(c) == 0) continue;
    if (words.empty() || words.back().end != i) words.push_back({i, i, {}});
    words.back().text += static_cast<char>(std::tolower(c));
    words.back().end = i + 1;
  }
  return words;
}

struct Region {
  char letter;
  int last, before;  // the last number, and how many vertebrae stand above the region
  std::array<std::string_view, 2> words;
};
// T13 and L6 are counted where a spine has them.
constexpr Region regions[] = {{'C', 7, 0, {"cervical", "cervicalis"}},
                              {'T', 13, 7, {"thoracic", "thoracica"}},
                              {'L', 6, 19, {"lumbar", "lumbalis"}},
                              {'S', 1, 24, {"sacral", "sacralis"}}};

constexpr int rank_of_l1 = 2 * 20, rank_of_sacrum = 2 * 25;

const Region* region_named(const std::string& word) {
  for (const Region& region : regions)
    if (std::find(region.words.begin(), region.words.end(), word) != region.words.end()) return &region;
  return nullptr;
}

bool is_about_vertebrae(const std::string& word) {
  static const std::set<std::string> known{"vertebra", "vertebrae", "vertebral", "vert", "bone", "mask"};
  return known.contains(word);
}

// 1 for "1" and "first"; 0 for a word that is no small number.
int number_of(const std::string& word) {
  static const std::array<std::string, 12> ordinals{"first", "second", "third",    "fourth",
                                                    "fifth", "sixth",  "seventh",  "eighth",
                                                    "ninth", "tenth",  "eleventh", "twelfth"};
  if (const auto found = std::find(ordinals.begin(), ordinals.end(), word); found != ordinals.end())
    return static_cast<int>(found - ordinals.begin()) + 1;
  const bool digits = !word.empty() && word.size() <= 2 && word.front() != '0' &&
                      std::all_of(word.begin(), word.end(), [](char c) { return c >= '0' && c <= '9'; });
  return digits ? std::stoi(word) : 0;
}

std::string level_text(const Region& region, int number) { return region.letter + std::to_string(number); }

// "l1", "th4" and "sacrum".
std::optional<std::string> level_word(const std::string& word) {
  if (word == "sacrum" || word == "coccyx") return word;
  const std::size_t letters = word.starts_with("th") ? 2 : 1;
  for (const Region& region : regions) {
    if (std::toupper(static_cast<unsigned char>(word.front())) != region.letter || word.size() <= letters)
      continue;
    const std::string digits = word.substr(letters);
    const bool is_number = std::isdigit(static_cast<unsigned char>(digits.front())) != 0;
    const int number = is_number ? number_of(digits) : 0;
    if (number >= 1 && number <= region.last) return level_text(region, number);
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> level_of(std::string_view name) {
  std::optional<std::string> level;
  const Region* region = nullptr;
  int number = 0;
  for (const Word& word : words_of(name)) {
    if (auto found = level_word(word.text)) {
      if (level && *level != *found) return std::nullopt;
      level = std::move(found);
    } else if (const Region* named = region_named(word.text)) {
      if (region != nullptr && region != named) return std::nullopt;
      region = named;
    } else if (const int found_number = number_of(word.text)) {
      if (number != 0) return std::nullopt;
      number = found_number;
    } else if (!is_about_vertebrae(word.text)) {
      return std::nullopt;
    }
  }
  if (level)
    return number == 0 && (region == nullptr || region->letter == level->front()) ? level : std::nullopt;
  if (region == nullptr || number < 1 || number > region->last) return std::nullopt;
  return level_text(*region, number);
}

std::optional<LevelInName> level_in_file_name(std::string_view stem) {
  const std::vector<Word> words = words_of(stem);
  // A level right after "vertebra" is meant as one; without such a word, any other that stands alone. A small
  // s and a number are a subject ("s1_L2").
  std::vector<std::size_t> levels, after_vertebra;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (!level_word(words[i].text) ||
        (stem[words[i].begin] == 's' && words[i].text.front() == 's' && words[i].text != "sacrum"))
      continue;
    levels.push_back(i);
    if (i > 0 && words[i - 1].text.starts_with("vertebra")) after_vertebra.push_back(i);
  }
  if (!after_vertebra.empty()) levels = after_vertebra;
  if (levels.size() != 1) return std::nullopt;
  LevelInName found;
  found.level = *level_word(words[levels.front()].text);
  std::size_t copied = 0;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const Word& word = words[i];
    if (i != levels.front() && !is_about_vertebrae(word.text)) {
      if (!found.rest.empty()) found.rest += stem.substr(copied, word.begin - copied);
      found.rest += stem.substr(word.begin, word.end - word.begin);
    }
    copied = word.end;
  }
  return found;
}

std::optional<char> region_in_file_name(std::string_view stem) {
  std::optional<char> letter;
  for (const Word& word : words_of(stem))
    if (const Region* region = region_named(word.text)) {
      if (letter && *letter != region->letter) return std::nullopt;
      letter = region->letter;
    }
  return letter;
}

std::optional<int> rank_of_level(std::string_view level) {
  if (level == "sacrum" || level == "S1") return rank_of_sacrum;
  if (level == "coccyx") return rank_of_sacrum + 2;
  if (level == "T13" || level == "L6") return level == "T13" ? rank_of_l1 - 1 : rank_of_sacrum - 1;
  if (level.size() < 2) return std::nullopt;
  const int number = number_of(std::string(level.substr(1)));
  for (const Region& region : regions)
    if (level.front() == region.letter && number >= 1 && number <= region.last)
      return 2 * (region.before + number);
  return std::nullopt;
}

}  // namespace foramen
