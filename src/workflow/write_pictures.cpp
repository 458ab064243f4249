#include "workflow/write_pictures.hpp"

#include "io/atomic_file.hpp"

namespace foramen {

std::vector<WrittenPicture> write_pictures(const PicturesRequest& request) {
  const std::vector<RenderedFile> rendered = render_model(request.model, request.render);
  make_folder(request.output);
  std::vector<WrittenPicture> written;
  for (const RenderedFile& picture : rendered) {
    written.push_back({request.output / picture.name, picture.caption});
    write_file(written.back().file, picture.bytes);
  }
  return written;
}

}  // namespace foramen
