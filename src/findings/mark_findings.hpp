#pragma once
/// \file
/// Errors of marks and overlap of regions as text, tables and differences of two models.

#include <string>
#include <vector>

#include "findings/model_difference.hpp"
#include "findings/model_report.hpp"

namespace foramen {

/// "mean ± standard error", or the mean alone if its error is not known.
std::string fixed(const TransferEstimate& value, int digits);

/// The figures that are quoted first, a line each; none if nothing was marked.
std::vector<std::string> mark_lines(const Evaluation& evaluation);

/// Errors by mark and overlap by region, with a column per evaluation; none if nothing was marked in any.
std::vector<ReportTable> mark_tables(const std::vector<NamedEvaluation>& evaluations);

/// Differences of marks and regions that both models have, over the pairs of shapes that both have, with the
/// jackknife over subjects. For the sign-flip test, all pairs that start at a subject change sign together.
/// Empty if nothing is in common.
/// \param partner  for each shape of the first evaluation, that of the second
std::vector<DifferenceGroup> mark_differences(const Evaluation& first, const Evaluation& second,
                                              const std::vector<std::size_t>& partner);

}  // namespace foramen
