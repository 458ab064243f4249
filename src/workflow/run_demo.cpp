#include "workflow/run_demo.hpp"

#include "workflow/write_synth_cohort.hpp"

namespace foramen {

DemoSummary run_demo(const DemoRequest& request, const RunContext& ctx) {
  const SynthSummary cohort = write_synth_cohort({request.output, request.synth}, ctx);
  BuildRequest build;
  build.inputs = {cohort.surfaces};
  build.output = request.output / "model";
  build.truth = cohort.truth;
  build.build = request.build;
  build.evaluation = request.evaluation;
  build.canonical_command = request.canonical_command;
  return {run_build(build, ctx), build.output / "report.html"};
}

}  // namespace foramen
