#include "modelfiles/extraction_record.hpp"

#include "modelfiles/json_fields.hpp"
#include "modelfiles/options_json.hpp"

namespace foramen {

using nlohmann::ordered_json;

ordered_json extraction_json(const ExtractionReport& report) { return json_of(report); }

ordered_json label_options_json(const LabelRequest& request) {
  ordered_json out = {{"labels", request.labels ? ordered_json(request.labels->text()) : ordered_json()}};
  out["numbering"] = request.numbering ? ordered_json(word_of(*request.numbering)) : ordered_json();
  out.update(described_json(request.surface));
  return out;
}

}  // namespace foramen
