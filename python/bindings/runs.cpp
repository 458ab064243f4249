#include <algorithm>
#include <filesystem>
#include <optional>

#include <pybind11/stl.h>
#include <nlohmann/json.hpp>

#include "bindings.hpp"
#include "exchange/convert.hpp"
#include "findings/compare_models.hpp"
#include "foramen/core/error.hpp"
#include "options.hpp"
#include "remedy_words.hpp"
#include "workflow/build_choices.hpp"
#include "workflow/evaluate_folder.hpp"
#include "workflow/label_choices.hpp"
#include "workflow/run_build.hpp"
#include "workflow/run_extract.hpp"
#include "workflow/write_pictures.hpp"
#include "workflow/write_report.hpp"

namespace foramen::python {
namespace {

// A value as a user would type it on a command line.
std::string shown(py::handle value) {
  if (py::isinstance<py::str>(value)) return value.cast<std::string>();  // includes members of enumerations
  return py::str(py::reinterpret_borrow<py::object>(value)).cast<std::string>();
}

std::string file_name(const std::string& path) {
  return std::filesystem::path(path).lexically_normal().filename().string();
}

// The command of the program that writes the same files. The files record it.
class CanonicalCommand {
 public:
  CanonicalCommand(const std::string& verb, const std::vector<std::string>& inputs)
      : text_("foramen " + verb) {
    for (const std::string& input : inputs) add_word(file_name(input));
  }

  // Adds the options of a struct that a dict sets, in their order. Unset options and switches that are off
  // are left out.
  template <DescribedOptions Options>
  void add(const Options& options, const py::dict& given) {
    for_each_option(options, [&](const std::string& path, const auto& field, const OptionText&) {
      const py::str name(path);
      if (!given.contains(name) || given[name].is_none()) return;
      using Field = std::remove_cvref_t<decltype(field)>;
      if constexpr (std::is_same_v<Field, bool>) {
        if (field) add_flag(path);
      } else {
        const py::object value = detail::python_value(field);
        add(path, py::isinstance<py::str>(value) ? shown(value) : shown(given[name]));
      }
    });
  }
  void add(const std::string& name, const std::string& value) {
    add_flag(name);
    add_word(name == "label_names" ? std::filesystem::path(value).filename().string() : value);
  }
  void add_flag(std::string name) {
    std::replace(name.begin(), name.end(), '_', '-');
    text_ += " --";
    text_ += name;
  }
  const std::string& text() const { return text_; }

 private:
  void add_word(const std::string& word) {
    text_ += ' ';
    text_ += word;
  }

  std::string text_;
};

struct GivenLabels {
  LabelChoices choices;
  std::optional<LabelRequest> request;
};

GivenLabels labels_from(const py::dict& given) {
  GivenLabels labels;
  set_options(labels.choices, given, "labels");
  labels.request = label_request(labels.choices);
  return labels;
}

// Throws if limits of repair are given although no repair is requested.
std::optional<RepairOptions> repair_from(bool repair, const py::dict& limits) {
  if (!repair) {
    for (const auto& [name, limit] : limits)
      throw InvalidInput(shown(name) + " has no effect without repair=True; leave it out");
    return std::nullopt;
  }
  RepairOptions options;
  set_options(options, limits, "repair");
  return options;
}

void add_repair(CanonicalCommand& command, const std::optional<RepairOptions>& repair,
                const py::dict& limits) {
  if (!repair) return;
  command.add_flag("repair");
  for (const char* limit : {"handle_limit", "hole_limit"})
    if (limits.contains(limit)) command.add(limit, shown(limits[limit]));
}

std::string build_folder(const std::vector<std::string>& inputs, const std::string& output,
                         const py::dict& chosen, const py::dict& labels, bool repair, const py::dict& limits,
                         const std::optional<std::string>& units, const std::string& truth, bool refit,
                         bool resume, const std::string& store, int threads, const py::object& progress) {
  BuildChoices choices;
  set_options(choices, chosen, "build");
  const GivenLabels given_labels = labels_from(labels);
  BuildRequest request;
  request.inputs.assign(inputs.begin(), inputs.end());
  request.output = output;
  request.unit = unit_named(units);
  request.labels = given_labels.request;
  request.repair = repair_from(repair, limits);
  request.build = build_options(choices);
  request.evaluation = evaluation_options(choices);
  request.refit = refit;
  request.subject_pattern = choices.subject_regex.value_or("");
  request.truth = truth;
  request.resume = resume;
  request.store = store;
  if (!truth.empty() && !std::filesystem::is_directory(truth))
    throw InvalidInput("truth: there is no folder " + truth);

  CanonicalCommand command("build", words_of_inputs(inputs, find_shape_files));
  command.add(choices, chosen);
  if (units) command.add("units", *units);
  command.add(given_labels.choices, labels);
  add_repair(command, request.repair, limits);
  if (refit) command.add_flag("refit");
  request.canonical_command = command.text();
  BuildSummary summary;
  run_unlocked(threads, progress, [&](const RunContext& ctx) { summary = run_build(request, ctx); });
  warn(summary.notes);
  return summary.json;
}

std::string extract_folder(const std::vector<std::string>& inputs, const std::string& output,
                           const py::dict& labels, bool repair, const py::dict& limits, int threads,
                           const py::object& progress) {
  const GivenLabels given_labels = labels_from(labels);
  ExtractRequest request;
  request.inputs.assign(inputs.begin(), inputs.end());
  request.output = output;
  request.labels = given_labels.request.value_or(LabelRequest{});
  request.repair = repair_from(repair, limits);
  CanonicalCommand command("extract", words_of_inputs(inputs, find_label_maps));
  command.add(given_labels.choices, labels);
  add_repair(command, request.repair, limits);
  request.canonical_command = command.text();
  std::string json;
  run_unlocked(threads, progress, [&](const RunContext& ctx) { json = run_extract(request, ctx).json; });
  return json;
}

std::string evaluate_files(const std::string& corresponding, const std::string& shapes,
                           const std::string& truth, const std::string& true_landmarks,
                           const std::string& output, const std::vector<std::string>& marks,
                           const std::vector<std::string>& regions, const std::optional<std::string>& units,
                           const std::string& subject_regex, const py::dict& options, int threads,
                           const py::object& progress) {
  EvaluateFolderRequest request;
  request.corresponding = corresponding;
  request.shapes = shapes;
  request.truth = truth;
  request.true_landmarks = true_landmarks;
  request.output = output;
  request.marks.assign(marks.begin(), marks.end());
  request.regions.assign(regions.begin(), regions.end());
  request.unit = unit_named(units);
  request.subject_pattern = subject_regex;
  set_options(request.options, options, "evaluate");
  std::optional<EvaluatedFolder> result;
  run_unlocked(threads, progress, [&](const RunContext& ctx) { result = evaluate_folder(request, ctx); });
  warn(result->notes);
  return result->json;
}

std::string compare(const std::vector<std::string>& models) {
  const py::gil_scoped_release unlocked;
  return compare_models({models.begin(), models.end()}).json;
}

std::string report(const std::string& model, const std::string& output, const std::string& baseline,
                   bool plain) {
  const py::gil_scoped_release unlocked;
  ReportRequest request{.model = model, .output = output, .page = {.baseline = baseline}};
  if (plain) request.page.kind = PageKind::plain;
  return write_report(request).file.string();
}

// Returns files, shapes, landmarks and notes.
py::tuple convert_files(const std::string& input, const std::string& output, const py::object& format,
                        const std::optional<std::string>& unit, const std::string& triangles,
                        const py::object& scale, int threads, const py::object& progress) {
  ConvertRequest request{.input = input, .output = output};
  detail::set_field(request.format, format, "to");
  request.unit = unit_named(unit);
  request.triangles = triangles;
  if (!scale.is_none()) detail::set_field(request.scale, scale, "scale");
  CanonicalCommand command("convert", {input});
  if (request.scale == ScaleMode::remove) command.add("scale", "remove");
  request.command = command.text();
  ConvertSummary summary;
  run_unlocked(threads, progress, [&](const RunContext& ctx) { summary = foramen::convert(request, ctx); });
  std::vector<std::string> notes;
  for (const Message& note : summary.notes) notes.push_back(worded(note));
  return py::make_tuple(summary.files, summary.shapes, summary.landmarks, notes);
}

std::string render(const std::string& model, const std::string& output, const std::string& baseline,
                   bool only_curves) {
  const py::gil_scoped_release unlocked;
  auto captions = nlohmann::ordered_json::object();
  for (const WrittenPicture& picture :
       write_pictures({model, output, {.baseline = baseline, .only_curves = only_curves}}))
    captions[picture.file.filename().string()] = picture.caption;
  return text_of(captions);
}

}  // namespace

void add_runs(py::module_& module) {
  module.def("build_folder", &build_folder);
  module.def("extract", &extract_folder);
  module.def("evaluate_folder", &evaluate_files);
  module.def("compare", &compare);
  module.def("report", &report);
  module.def("convert", &convert_files);
  module.def("render", &render);
}

}  // namespace foramen::python
