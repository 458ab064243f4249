#include "evaluate/subject_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "foramen/core/error.hpp"

namespace foramen::detail {
namespace {

using Groups = std::vector<std::vector<PairValue>>;

constexpr int nobody = -1;

// The mean over groups without the pairs of one subject; nullopt if no pair remains.
std::optional<double> mean_without(const Groups& groups, const PairSubjects& subjects, int subject) {
  double sum = 0;
  int counted = 0;
  for (const auto& group : groups) {
    double sum_of_group = 0;
    int pairs = 0;
    for (const PairValue& pair : group) {
      if (subjects.of(pair.from) == subject || subjects.of(pair.to) == subject) continue;
      sum_of_group += pair.value;
      ++pairs;
    }
    if (pairs == 0) continue;
    sum += sum_of_group / pairs;
    ++counted;
  }
  if (counted == 0) return std::nullopt;
  return sum / counted;
}

std::optional<double> jackknife_error(const Groups& groups, const PairSubjects& subjects,
                                      const std::set<int>& occurring) {
  std::vector<double> means;
  for (const int subject : occurring) {
    const auto mean = mean_without(groups, subjects, subject);
    if (!mean) return std::nullopt;
    means.push_back(*mean);
  }
  double average = 0, squares = 0;
  const auto count = static_cast<double>(means.size());
  for (const double m : means) average += m / count;
  for (const double m : means) squares += (m - average) * (m - average);
  return std::sqrt((count - 1) / count * squares);
}

}  // namespace

PairSubjects::PairSubjects(int shapes, const std::vector<std::string>& subjects) {
  std::vector<std::string> names;
  for (int i = 0; i < shapes; ++i) {
    if (subjects.empty()) {
      of_shape_.push_back(i);
      continue;
    }
    const auto found = std::find(names.begin(), names.end(), subjects[i]);
    of_shape_.push_back(static_cast<int>(found - names.begin()));
    if (found == names.end()) names.push_back(subjects[i]);
  }
}

TransferEstimate mean_over_pairs(const std::vector<PairValue>& values, const PairSubjects& subjects) {
  return mean_over_groups({values}, subjects);
}

TransferEstimate mean_over_groups(const Groups& groups, const PairSubjects& subjects) {
  std::set<int> occurring;
  std::set<std::pair<int, int>> pairs;
  for (const auto& group : groups)
    for (const PairValue& pair : group) {
      occurring.insert({subjects.of(pair.from), subjects.of(pair.to)});
      pairs.insert({pair.from, pair.to});
    }
  const auto mean = mean_without(groups, subjects, nobody);
  FORAMEN_ASSERT(mean.has_value());
  return {*mean, jackknife_error(groups, subjects, occurring), static_cast<int>(pairs.size())};
}

}  // namespace foramen::detail
