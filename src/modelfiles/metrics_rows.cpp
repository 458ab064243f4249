#include "modelfiles/metrics_rows.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "foramen/core/error.hpp"
#include "io/table_file.hpp"

namespace foramen {
namespace {

// Rows of metrics.csv.
class MetricRows {
 public:
  void add(const std::string& item, const char* kind, int modes, const char* measure, double value,
           const char* unit) {
    rows_.push_back({item, std::string(kind), static_cast<std::int64_t>(modes), std::string(measure), value,
                     std::string(unit)});
  }
  void add(const std::vector<ErrorsAtModes>& by_modes, const std::vector<std::string>& items,
           const char* kind, const std::string& measure) {
    for (const ErrorsAtModes& e : by_modes)
      for (std::size_t i = 0; i < e.items.size(); ++i) {
        const std::string item = items.empty() ? std::to_string(i + 1) : items[i];
        add(item, kind, e.modes, (measure + "_hausdorff").c_str(), e.items[i].hausdorff, "mm");
        add(item, kind, e.modes, (measure + "_mean_surface").c_str(), e.items[i].mean_surface, "mm");
        add(item, kind, e.modes, (measure + "_landmark_rms").c_str(), e.items[i].landmark_rms, "mm");
      }
  }
  const std::vector<Row>& rows() const { return rows_; }

 private:
  std::vector<Row> rows_;
};

// The values of shapes in metrics.csv.
class ShapeFigures {
 public:
  explicit ShapeFigures(const std::filesystem::path& file) : file_(file.string()) {
    const Table table = read_csv(file);
    try {
      const std::size_t item = table.column("item"), kind = table.column("kind"),
                        modes = table.column("modes"), measure = table.column("measure"),
                        value = table.column("value");
      for (const auto& row : table.rows)
        if (row[kind] == "shape") figures_[{row[measure], row[modes], row[item]}] = parse_number(row[value]);
    } catch (const IoError& e) {
      throw IoError(file_ + ": " + e.what());
    }
  }
  double at(const std::string& measure, int modes, const std::string& shape) const {
    const auto found = figures_.find({measure, std::to_string(modes), shape});
    if (found == figures_.end())
      throw IoError(file_ + ": holds no " + measure + " of " + shape + " at " + std::to_string(modes) +
                        " modes, as metrics.json beside it says; an evaluation of the model writes both anew",
                    {{RemedyKind::evaluate_model}});
    return found->second;
  }
  void fill(Generalization& generalization, const std::string& measure,
            const std::vector<std::string>& names) const {
    for (ErrorsAtModes& e : generalization.by_modes)
      for (const std::string& name : names)
        e.items.push_back({at(measure + "_hausdorff", e.modes, name),
                           at(measure + "_mean_surface", e.modes, name),
                           at(measure + "_landmark_rms", e.modes, name)});
  }

 private:
  std::string file_;
  std::map<std::array<std::string, 3>, double> figures_;  // by measure, number of modes, shape
};

}  // namespace

void write_metrics_rows(const std::filesystem::path& file, const Evaluation& e) {
  MetricRows rows;
  for (std::size_t i = 0; i < e.names.size(); ++i) {
    const ShapeRepresentation& r = e.representation.shapes[i];
    rows.add(e.names[i], "shape", 0, "representation_mean", r.distance.mean, "mm");
    rows.add(e.names[i], "shape", 0, "representation_p95", r.distance.p95, "mm");
    rows.add(e.names[i], "shape", 0, "representation_hausdorff", r.distance.hausdorff, "mm");
    rows.add(e.names[i], "shape", 0, "flips_plain", r.plain_flips, "triangles");
    rows.add(e.names[i], "shape", 0, "flips_confirmed", r.confirmed_flips, "triangles");
    rows.add(e.names[i], "shape", 0, "opposing_mean", r.opposing_mean, "triangles");
    rows.add(e.names[i], "shape", 0, "self_intersections", r.self_intersections, "pairs of triangles");
    rows.add(e.names[i], "shape", 0, "input_self_intersections", r.input_self_intersections,
             "pairs of triangles");
    if (e.truth) rows.add(e.names[i], "shape", 0, "truth_error_mean", e.truth->mean_from_shape[i], "mm");
  }
  rows.add(e.leave_one_out.by_modes, e.names, "shape", "generalization");
  if (e.leave_subject_out)
    rows.add(e.leave_subject_out->by_modes, e.names, "shape", "generalization_by_subject");
  if (e.refit) rows.add(e.refit->generalization.by_modes, e.refit->names, "shape", "refit");
  if (e.refit_by_subject)
    rows.add(e.refit_by_subject->generalization.by_modes, e.refit_by_subject->names, "shape",
             "refit_by_subject");
  rows.add(e.specificity.by_modes, {}, "draw", "specificity");
  const int all_modes = e.compactness.empty() ? 0 : e.compactness.back().modes;
  for (std::size_t i = 0; i < e.drawn.draws.size(); ++i) {
    const DrawnShape& d = e.drawn.draws[i];
    const std::string item = std::to_string(i + 1);
    rows.add(item, "draw", all_modes, "drawn_self_intersections", d.self_intersections, "pairs of triangles");
    rows.add(item, "draw", all_modes, "drawn_folded", d.folded, "triangles");
    rows.add(item, "draw", all_modes, "drawn_opposing_mean", d.opposing_mean, "triangles");
  }
  const auto pair_name = [&](int from, int to) { return e.names[from] + " to " + e.names[to]; };
  if (e.marks)
    for (const MarkPair& p : e.marks->pairs) {
      if (p.points) rows.add(pair_name(p.from, p.to), "pair", 0, "mark_points", *p.points, "mm");
      if (p.curves) rows.add(pair_name(p.from, p.to), "pair", 0, "mark_curves", *p.curves, "mm");
    }
  if (e.regions)
    for (const RegionPair& p : e.regions->pairs)
      rows.add(pair_name(p.from, p.to), "pair", 0, "region_dice", p.dice, "share");
  write_csv(file, {"item", "kind", "modes", "measure", "value", "unit"}, rows.rows());
}

void read_shape_items(const std::filesystem::path& file, Evaluation& e) {
  const ShapeFigures figures(file);
  figures.fill(e.leave_one_out, "generalization", e.names);
  if (e.leave_subject_out) figures.fill(*e.leave_subject_out, "generalization_by_subject", e.names);
  if (e.refit) figures.fill(e.refit->generalization, "refit", e.refit->names);
  if (e.refit_by_subject)
    figures.fill(e.refit_by_subject->generalization, "refit_by_subject", e.refit_by_subject->names);
}

}  // namespace foramen
