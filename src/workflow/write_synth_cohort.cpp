#include "workflow/write_synth_cohort.hpp"

#include <cstdio>
#include <string>

#include "foramen/io/mesh_file.hpp"
#include "io/atomic_file.hpp"

namespace foramen {
namespace {

std::string synth_name(int index) {
  char name[32];
  std::snprintf(name, sizeof name, "synth%03d.ply", index + 1);
  return name;
}

}  // namespace

SynthSummary write_synth_cohort(const SynthRequest& request, const RunContext& ctx) {
  SynthSummary written{request.options.shapes, request.output / "shapes", request.output / "truth"};
  const auto shapes = synth_cohort(request.options, ctx);
  make_folder(written.surfaces);
  make_folder(written.truth);
  for (int i = 0; const SynthShape& shape : shapes) {
    const std::string file = synth_name(i++);
    write_ply(written.surfaces / file, shape.surface);
    write_ply(written.truth / file, shape.truth);
  }
  return written;
}

}  // namespace foramen
