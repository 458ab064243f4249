#include "workflow/write_report.hpp"

#include "io/atomic_file.hpp"

namespace foramen {

WrittenReport write_report(const ReportRequest& request) {
  const ModelPage page = model_page(request.model, request.page);
  const std::filesystem::path file = request.output.empty() ? request.model / "report.html" : request.output;
  write_file(file, page.html);
  return {file, page.remark};
}

}  // namespace foramen
