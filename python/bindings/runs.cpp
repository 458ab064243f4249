#include <algorithm>

#include <pybind11/stl.h>

#include "bindings.hpp"
#include "build_options.hpp"
#include "convert_options.hpp"
#include "foramen/core/error.hpp"
#include "foramen/findings/compare_models.hpp"
#include "foramen/io/atomic_file.hpp"
#include "foramen/pages/model_page.hpp"
#include "foramen/pages/render_model.hpp"
#include "foramen/workflow/evaluate_folder.hpp"
#include "foramen/workflow/run_extract.hpp"

namespace foramen::python {
namespace {

// Options as the program's command line has them, so that they mean the same.
void parse(CLI::App& command, std::vector<std::string> arguments) {
  std::reverse(arguments.begin(), arguments.end());  // as CLI11 wants them
  try {
    command.parse(std::move(arguments));
  } catch (const CLI::ParseError& e) {
    throw InvalidInput(e.what());
  }
}

std::string build(const std::vector<std::string>& inputs, const std::string& output,
                  const std::vector<std::string>& options, int threads, const py::object& progress) {
  CLI::App command("", "build");
  app::BuildArguments arguments;
  arguments.add_to(command);
  parse(command, options);
  BuildRequest request;
  try {
    request = arguments.request(inputs, output, app::canonical_command(command, inputs));
  } catch (const CLI::ParseError& e) {
    throw InvalidInput(e.what());
  }
  std::string json;
  run_unlocked(threads, progress, [&](const RunContext& ctx) { json = run_build(request, ctx).json; });
  return json;
}

std::string extract(const std::vector<std::string>& inputs, const std::string& output,
                    const std::vector<std::string>& options, int threads, const py::object& progress) {
  CLI::App command("", "extract");
  app::LabelFlags flags;
  RepairOptions repair_options;
  bool repair = false;
  flags.add_to(command);
  command.add_flag("--repair", repair);
  app::add_repair_options(command, repair_options);
  parse(command, options);
  ExtractRequest request;
  request.inputs.assign(inputs.begin(), inputs.end());
  request.output = output;
  try {
    request.labels = flags.resolved().value_or(LabelRequest{});
  } catch (const CLI::ParseError& e) {
    throw InvalidInput(e.what());
  }
  if (repair) request.repair = repair_options;
  request.canonical_command = app::canonical_command(command, inputs);
  std::string json;
  run_unlocked(threads, progress, [&](const RunContext& ctx) { json = run_extract(request, ctx).json; });
  return json;
}

std::string evaluate(const std::string& corresponding, const std::string& shapes, const std::string& truth,
                     const std::string& true_landmarks, const std::string& output, int samples,
                     std::uint64_t seed, const std::string& subject_regex, bool remove_scale,
                     bool area_weights, int threads, const py::object& progress) {
  EvaluateFolderRequest request;
  request.corresponding = corresponding;
  request.shapes = shapes;
  request.truth = truth;
  request.true_landmarks = true_landmarks;
  request.output = output;
  request.subject_pattern = subject_regex;
  request.options.draws = samples;
  request.options.seed = seed;
  request.options.scale = remove_scale ? ScaleMode::remove : ScaleMode::keep;
  request.options.weights = area_weights ? LandmarkWeights::area : LandmarkWeights::equal;
  std::string json;
  run_unlocked(threads, progress, [&](const RunContext& ctx) { json = evaluate_folder(request, ctx).json; });
  return json;
}

std::string compare(const std::vector<std::string>& models) {
  const py::gil_scoped_release unlocked;
  return compare_models({models.begin(), models.end()}).json;
}

std::string report(const std::string& model, const std::string& output, const std::string& baseline,
                   bool plain) {
  const py::gil_scoped_release unlocked;
  PageOptions options;
  if (plain) options.kind = PageKind::plain;
  options.baseline = baseline;
  const ModelPage page = model_page(model, options);
  std::string path = output.empty() ? (std::filesystem::path(model) / "report.html").string() : output;
  write_file(path, page.html);
  return path;
}

std::string convert(const std::string& input, const std::string& output,
                    const std::vector<std::string>& options, int threads, const py::object& progress) {
  CLI::App command("", "convert");
  ConvertRequest request{.input = input, .output = output};
  app::add_convert_options(command, request);
  parse(command, options);
  request.command = app::recorded_command(request);
  ConvertSummary summary;
  run_unlocked(threads, progress, [&](const RunContext& ctx) { summary = foramen::convert(request, ctx); });
  return text_of(app::convert_json(request, summary));
}

std::string render(const std::string& model, const std::string& output, const std::string& baseline,
                   bool only_curves) {
  const py::gil_scoped_release unlocked;
  return text_of(
      write_rendered(render_model(model, {.baseline = baseline, .only_curves = only_curves}), output));
}

}  // namespace

void add_runs(py::module_& module) {
  module.def("build", &build);
  module.def("extract", &extract);
  module.def("evaluate", &evaluate);
  module.def("compare", &compare);
  module.def("report", &report);
  module.def("convert", &convert);
  module.def("render", &render);
}

}  // namespace foramen::python
