#include "workflow/sample_model.hpp"

#include <atomic>
#include <cstdio>
#include <string>

#include "core/parallel.hpp"
#include "foramen/io/mesh_file.hpp"
#include "io/atomic_file.hpp"
#include "modelfiles/model_folder.hpp"

namespace foramen {
namespace {

std::string sample_name(int index) {
  char name[32];
  std::snprintf(name, sizeof name, "sample%04d.ply", index + 1);
  return name;
}

}  // namespace

std::vector<Message> sample_model(const SampleRequest& request, const RunContext& ctx) {
  const LoadedModel loaded = load_model(request.model);
  make_folder(request.output);
  const Rng root(request.seed);
  std::atomic<int> done{0};
  parallel_for(request.count, ctx, [&](int i) {
    Rng rng = root.fork(static_cast<std::uint64_t>(i));
    const Eigen::VectorXd shape = loaded.model.reconstruct(loaded.model.draw(rng));
    write_ply(request.output / sample_name(i), {unflattened(shape), loaded.model.triangles()}, loaded.space);
    ctx.step("sample", static_cast<double>(++done) / request.count);
  });
  std::vector<Message> notes;
  for (const Message& note : loaded.notes) notes.push_back(note.about(request.model.string()));
  return notes;
}

}  // namespace foramen
