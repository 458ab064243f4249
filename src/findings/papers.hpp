#pragma once

#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace foramen {

struct Paper {
  std::string_view citation, used_for;
};

/// The papers whose methods a model uses, by the options of its run record.
std::vector<Paper> papers_used(const nlohmann::ordered_json& options);

}  // namespace foramen
