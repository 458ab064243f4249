// Reads any bytes as each file of a model. The bytes must be refused with one of our errors, or the result
// must be valid.
#include "foramen/core/error.hpp"
#include "foramen/io/statismo_file.hpp"
#include "fuzz_input.hpp"
#include "modelfiles/atlas_file.hpp"
#include "modelfiles/metrics_file.hpp"

namespace foramen {
namespace {

template <class Read>
void read_or_refuse(const Read& read) {
  try {
    read();
  } catch (const Error&) {
  }
}

void fuzz(std::string_view bytes) {
  if (bytes.starts_with('{')) {
    read_or_refuse([&] { parse_metrics(bytes, "fuzzed"); });
    return;
  }
  const fuzzing::MemoryFile file(bytes);
  read_or_refuse([&] { read_statismo(file.path()); });
  read_or_refuse([&] { read_atlas(file.path()); });
}

}  // namespace
}  // namespace foramen

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  foramen::fuzz({reinterpret_cast<const char*>(data), size});
  return 0;
}
