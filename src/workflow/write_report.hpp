#pragma once
/// \file
/// The report of a model, written again.

#include <filesystem>
#include <string>

#include "pages/model_page.hpp"

namespace foramen {

struct ReportRequest {
  std::filesystem::path model;        ///< a model's folder
  std::filesystem::path output = {};  ///< the file to write; empty: report.html in the model's folder
  PageOptions page = {};
};

struct WrittenReport {
  std::filesystem::path file;
  std::string remark;  ///< see ModelPage
};

/// Throws what model_page() throws; IoError.
WrittenReport write_report(const ReportRequest& request);

}  // namespace foramen
