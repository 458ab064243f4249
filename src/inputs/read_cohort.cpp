#include "inputs/read_cohort.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <variant>

#include "core/parallel.hpp"
#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/topology/inspect_mesh.hpp"
#include "inputs/label_map_notes.hpp"
#include "inputs/surface_size.hpp"
#include "inputs/unused_points.hpp"
#include "io/sha256.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;

TriangleSoup in_millimetres(TriangleSoup soup, LengthUnit unit) {
  if (unit != LengthUnit::millimetre)
    for (Vec3& p : soup.points) p *= millimetres_per(unit);
  return soup;
}

// A shape of the list with the same surface as this one; null if there is none.
const InputShape* same_surface(const InputShape& shape, const std::vector<InputShape>& others) {
  const auto found = std::find_if(others.begin(), others.end(), [&](const InputShape& other) {
    const auto a = shape.mesh.positions(), b = other.mesh.positions();
    return shape.mesh.triangles() == other.mesh.triangles() &&
           std::equal(a.begin(), a.end(), b.begin(), b.end());
  });
  return found == others.end() ? nullptr : &*found;
}

std::string source_text(const std::string& file_name, std::optional<int> label) {
  return label ? file_name + ", label " + std::to_string(*label) : file_name;
}

void read_meshes(const std::vector<ShapeFile>& files, const InputUnit& unit,
                 const std::optional<RepairOptions>& repair, const RunContext& ctx, Cohort& cohort) {
  std::vector<std::variant<std::monostate, InputShape, LeftOut>> results(files.size());
  parallel_for(static_cast<int>(files.size()), ctx, [&](int i) {
    const ShapeFile& file = files[i];
    auto& result = results[i];
    try {
      InputShape shape = read_shape(file.path, unit, repair, ctx.with_threads(1).without_progress());
      shape.stem = file.name;
      shape.file_name = file.shown();
      shape.folder = file.folder;
      result = std::move(shape);
    } catch (const Cancelled&) {
      throw;
    } catch (const std::exception& e) {  // a defect of ours, too, must not cost the other shapes
      result = LeftOut{file.name, file.shown(), {}, reason_without_name(e, file.path)};
    }
  });
  for (auto& result : results) {
    auto* shape = std::get_if<InputShape>(&result);
    if (shape != nullptr) cohort.notes.insert(cohort.notes.end(), shape->notes.begin(), shape->notes.end());
    if (shape == nullptr)
      cohort.left_out.push_back(std::get<LeftOut>(std::move(result)));
    else if (const InputShape* original = same_surface(*shape, cohort.shapes))
      cohort.left_out.push_back({shape->stem, shape->file_name, shape->sha256,
                                 "the same surface as " + source_of(*original) +
                                     ", vertex by vertex; a model counts a shape once: remove the copy"});
    else {
      if (shape->size_note) cohort.notes.push_back(shape->size_note->about(source_of(*shape)));
      cohort.shapes.push_back(std::move(*shape));
    }
  }
}

// Adds the labels of the label maps to a cohort, one map after the other, so that only one is in memory.
// Surfaces of labels are always repaired, because noise of single voxels may leave handles on them.
class LabelMapReader {
 public:
  LabelMapReader(const LabelRequest& request, const std::optional<RepairOptions>& repair, Cohort& cohort)
      : request_(request), repair_(repair.value_or(RepairOptions{})), cohort_(cohort) {}

  void read(const ShapeFile& file, const RunContext& ctx) {
    const std::string name = file.shown();
    LabelSurfaces labels;
    try {
      labels = extract_labels(file.label_map(), request_, ctx);
    } catch (const Cancelled&) {
      throw;
    } catch (const Error& e) {
      cohort_.left_out.push_back({file.name, name, {}, reason_without_name(e, file.path)});
      return;
    }
    notes_.add(file.path, labels);
    for (const RefusedLabel& refused : labels.refused) {
      cohort_.left_out.push_back({refused.stem, name, labels.sha256, refused.reason, refused.label});
      if (refused.absent) absent_.emplace(refused.label, refused.reason.about(file.path.string()));
    }
    for (LabelSurface& label : labels.surfaces) {
      present_.insert(label.label);
      add(file, labels, label, ctx);
    }
    for (const RefusedLabel& refused : labels.refused)
      if (!refused.absent) present_.insert(refused.label);
    cohort_.notes.insert(cohort_.notes.end(), labels.notes.begin(), labels.notes.end());
  }

  void finish() const {
    const auto notes = notes_.messages();
    cohort_.notes.insert(cohort_.notes.end(), notes.begin(), notes.end());
    require_singles();
  }

 private:
  // Throws InvalidInput if a label that was given by itself, not in a range, is in no label map.
  void require_singles() const {
    for (const auto& [label, reason] : absent_)
      if (!present_.contains(label)) throw InvalidInput(reason.about("label " + std::to_string(label)));
  }

  void add(const ShapeFile& file, const LabelSurfaces& labels, LabelSurface& label, const RunContext& ctx) {
    InputShape shape;
    shape.stem = label.stem;
    shape.file_name = file.shown();
    shape.folder = file.folder;
    shape.sha256 = labels.sha256;
    shape.names_from = labels.names_from;
    shape.label = label.label;
    shape.extraction = label.extracted.report;
    try {
      cohort_.shapes.push_back(usable_shape(std::move(shape), std::move(label.extracted.surface),
                                            LengthUnit::millimetre, repair_, ctx));
    } catch (const InvalidInput& e) {
      cohort_.left_out.push_back({label.stem, file.shown(), labels.sha256, message_of(e), label.label});
    }
  }

  const LabelRequest& request_;
  const std::optional<RepairOptions> repair_;
  Cohort& cohort_;
  std::map<int, Message> absent_;
  std::set<int> present_;
  LabelMapNotes notes_;
};

}  // namespace

Message reason_without_name(const std::exception& error, const fs::path& file) {
  Message reason = message_of(error);
  const std::string name = file.string() + ": ";
  if (reason.text.starts_with(name)) reason.text.erase(0, name.size());
  return reason;
}

std::string source_of(const InputShape& shape) { return source_text(shape.file_name, shape.label); }
std::string source_of(const LeftOut& shape) { return source_text(shape.file_name, shape.label); }

std::optional<Message> size_note(const Mesh& mesh, const InputUnit& unit) {
  return check_size(bounding_box(mesh.positions()).diagonal() / millimetres_per(unit.length), unit);
}

RepairedMesh repair_surface(TriangleSoup raw, const InputUnit& unit, const RepairOptions& options,
                            const RunContext& ctx) {
  // Stray pieces may make the bounding box too large for a vertebra. The unit is refused only if another one
  // would fit.
  const double diagonal = inspect_mesh(raw).box.diagonal();
  if (likely_unit(diagonal * millimetres_per(unit.length))) check_size(diagonal, unit);
  RepairedMesh repaired = repair_mesh(in_millimetres(std::move(raw), unit.length), options, ctx);
  size_note(repaired.mesh, unit);
  return repaired;
}

InputShape usable_shape(InputShape shape, TriangleSoup surface, const InputUnit& unit,
                        const std::optional<RepairOptions>& repair, const RunContext& ctx) {
  if (const auto note = drop_unused_points(surface))
    shape.notes.push_back(shape.file_name.empty() ? *note : note->about(shape.file_name));
  const MeshReport report = inspect_mesh(surface);
  if (const auto obstacle = obstacle_to_model(report)) {
    if (!repair) throw TopologyError(obstacle->message());
    RepairedMesh repaired = repair_surface(std::move(surface), unit, *repair, ctx);
    shape.repair = std::move(repaired.report);
    shape.mesh = std::move(repaired.mesh);
    shape.size_note = size_note(shape.mesh, unit);
    return shape;
  }
  if (!shape.label)
    shape.size_note = check_size(report.box.diagonal(), unit);
  else if (const auto doubt = doubt_about_label(report.box.diagonal()))
    throw InvalidInput(*doubt);
  shape.mesh = build_mesh(in_millimetres(std::move(surface), unit.length));
  shape.was_inward = report.inward;
  if (shape.was_inward) shape.mesh = reversed(shape.mesh);
  return shape;
}

InputShape read_shape(const fs::path& file, const InputUnit& unit, const std::optional<RepairOptions>& repair,
                      const RunContext& ctx) {
  InputShape shape;
  shape.stem = mesh_stem(file);
  shape.file_name = file.filename().string();
  MeshFile read = read_mesh(file);
  shape.sha256 = sha256_of_file(file);
  shape.space = read.space.value_or(AnatomicalSpace::lps);
  for (const Message& note : read.notes) shape.notes.push_back(note.about(shape.file_name));
  try {
    return usable_shape(std::move(shape), std::move(read.soup), unit, repair, ctx);
  } catch (const TopologyError& e) {
    throw TopologyError(message_of(e).about(file.string()));
  } catch (const InvalidInput& e) {
    throw InvalidInput(message_of(e).about(file.string()));
  }
}

Cohort read_cohort(const std::vector<ShapeFile>& files, const InputUnit& unit, const RunContext& ctx,
                   const LabelRequest& labels, const std::optional<RepairOptions>& repair) {
  Cohort cohort;
  std::vector<ShapeFile> meshes;
  LabelMapReader label_maps(labels, repair, cohort);
  for (const ShapeFile& file : files) {
    if (is_label_map(file.path))
      label_maps.read(file, ctx);
    else
      meshes.push_back(file);
  }
  label_maps.finish();
  read_meshes(meshes, unit, repair, ctx, cohort);
  const auto by_stem = [](const auto& a, const auto& b) { return a.stem < b.stem; };
  std::stable_sort(cohort.shapes.begin(), cohort.shapes.end(), by_stem);
  std::stable_sort(cohort.left_out.begin(), cohort.left_out.end(), by_stem);
  for (std::size_t i = 1; i < cohort.shapes.size(); ++i)
    if (cohort.shapes[i].stem == cohort.shapes[i - 1].stem)
      throw InvalidInput(source_of(cohort.shapes[i - 1]) + " and " + source_of(cohort.shapes[i]) +
                         " would both be named " + cohort.shapes[i].stem +
                         ": leave one out or rename its file");
  return cohort;
}

}  // namespace foramen
