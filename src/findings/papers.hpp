#pragma once

#include <string_view>
#include <vector>

#include "modelfiles/run_file.hpp"

namespace foramen {

struct Paper {
  std::string_view citation, used_for;
};

/// What a model rests on, by the options of its build.
std::vector<Paper> papers_used(const RunOptions& options);

}  // namespace foramen
