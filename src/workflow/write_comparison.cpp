#include "workflow/write_comparison.hpp"

#include "findings/compare_models.hpp"
#include "io/atomic_file.hpp"

namespace foramen {

ComparisonSummary write_comparison(const ComparisonRequest& request) {
  const ModelComparison comparison = compare_models(request.models);
  const std::filesystem::path page = request.output / "compare.html";
  make_folder(request.output);
  write_file(page, comparison.html);
  write_file(request.output / "compare.json", comparison.json + "\n");
  for (const auto& [name, svg] : comparison.charts) write_file(request.output / name, svg);
  return {comparison.text, comparison.json, page};
}

}  // namespace foramen
