#include "workflow/write_mode_shapes.hpp"

#include "modelfiles/model_folder.hpp"

namespace foramen {

ModeShapesSummary write_mode_shapes(const ModeShapesRequest& request) {
  const LoadedModel loaded = load_model(request.model);
  write_modes(request.output, loaded.model, request.sd, loaded.space);
  std::vector<Message> notes;
  for (const Message& note : loaded.notes) notes.push_back(note.about(request.model.string()));
  return {2 * loaded.model.modes(), notes};
}

}  // namespace foramen
