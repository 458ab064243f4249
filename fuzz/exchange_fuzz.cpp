// Reads any bytes as each kind of file that is exchanged with other tools. The bytes must be refused with one
// of our errors, or the result must be valid.
#include "foramen/core/error.hpp"
#include "fuzz_input.hpp"
#include "io/hdf5_json_file.hpp"
#include "io/named_points.hpp"
#include "io/scalismo_landmarks.hpp"
#include "io/shapeworks_project.hpp"

namespace foramen {
namespace {

template <class Read>
void read_or_refuse(const Read& read) {
  try {
    read();
  } catch (const Error&) {
  }
}

// Reads everything that a reader of models reads.
void read_tree(const std::filesystem::path& path) {
  const H5JsonReader file(path);
  for (const std::string& name : file.children("")) {
    read_or_refuse([&] { file.matrix<std::int32_t>("/" + name); });
    read_or_refuse([&] { file.vector<float>("/" + name); });
    read_or_refuse([&] { file.scalar<double>("/" + name); });
    read_or_refuse([&] { file.string("/" + name); });
    read_or_refuse([&] { file.attribute("/" + name, "datasetType"); });
    read_or_refuse([&] { file.children("/" + name); });
  }
}

void fuzz(std::string_view bytes) {
  const fuzzing::MemoryFile file(bytes);
  read_or_refuse([&] { read_tree(file.path()); });
  read_or_refuse([&] { read_shapeworks(file.path()); });
  read_or_refuse([&] { read_scalismo_landmarks(file.path()); });
  read_or_refuse([&] { read_particles(file.path()); });
  read_or_refuse([&] { read_tps(file.path()); });
  read_or_refuse([&] { read_landmark_table(file.path()); });
}

}  // namespace
}  // namespace foramen

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  foramen::fuzz({reinterpret_cast<const char*>(data), size});
  return 0;
}
