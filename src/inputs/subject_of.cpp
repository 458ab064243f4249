#include "inputs/subject_of.hpp"

#include <regex>

#include "foramen/core/error.hpp"

namespace foramen {

std::string subject_of(const std::string& stem, const std::string& pattern) {
  try {
    std::smatch match;
    if (!std::regex_search(stem, match, std::regex(pattern))) return stem;
    return match.size() > 1 && match[1].matched ? match[1].str() : match[0].str();
  } catch (const std::regex_error& e) {
    throw InvalidInput(
        "the pattern '" + pattern + "' of subjects is not a regular expression (" + e.what() + ")",
        {{RemedyKind::subject_pattern}});
  }
}

}  // namespace foramen
