#pragma once
/// \file
/// The errors of marks and the overlap of regions as JSON, as metrics.json has them.

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "foramen/evaluate/mark_transfer.hpp"
#include "foramen/evaluate/region_transfer.hpp"

namespace foramen {

/// \param names  of the cohort's shapes, by which the JSON calls them
nlohmann::ordered_json marks_json(const MarkTransfer& marks, const std::vector<std::string>& names);
nlohmann::ordered_json regions_json(const RegionTransfer& regions, const std::vector<std::string>& names);

/// What marks_json() and regions_json() wrote. Marks without places, as older versions wrote them, are read
/// too. Whether places are on triangles of a model is not known here. Throws nlohmann::json::exception or
/// IoError for anything else.
MarkTransfer marks_from(const nlohmann::ordered_json& json, const std::vector<std::string>& names);
RegionTransfer regions_from(const nlohmann::ordered_json& json, const std::vector<std::string>& names);

}  // namespace foramen
