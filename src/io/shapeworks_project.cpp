#include "io/shapeworks_project.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "foramen/core/error.hpp"
#include "io/json_text.hpp"
#include "io/table_file.hpp"
#include "io/xlsx_sheet.hpp"
#include "io/zip_archive.hpp"

namespace foramen {
namespace {

using nlohmann::ordered_json;

// Prefixes of the column that holds the shape of a subject; the name of the domain follows.
constexpr std::array input_prefixes{"shape_", "mesh_", "segmentation_", "contour_"};
constexpr std::array domain_prefixes{"shape_", "mesh_", "segmentation_", "contour_", "local_particles_"};

// Row by row, as VTK stores a 4x4 matrix.
std::string text_of(const Eigen::Matrix4d& matrix) {
  std::string text;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      if (!text.empty()) text += ' ';
      text += format_number(matrix(i, j));
    }
  return text;
}

ordered_json json_of(const ShapeWorksSubject& subject) {
  ordered_json out{{"name", subject.name}};
  const auto add_file = [&](const char* key, const std::filesystem::path& file) {
    if (!file.empty()) out[key] = file.generic_string();
  };
  add_file("shape_1", subject.shape);
  add_file("groomed_1", subject.groomed);
  add_file("local_particles_1", subject.local_particles);
  add_file("world_particles_1", subject.world_particles);
  out["alignment_1"] = text_of(subject.alignment);
  out["procrustes_1"] = text_of(subject.procrustes);
  return out;
}

class SubjectReader {
 public:
  SubjectReader(const io_detail::Source& source, const ordered_json& json, std::size_t index)
      : source_(source), place_("subject " + std::to_string(index + 1)) {
    if (!json.is_object()) refuse("is no object");
    for (const auto& [key, value] : json.items()) {
      if (value.is_string())
        texts_[key] = value.get<std::string>();
      else if (value.is_primitive() &&
               !value.is_null())  // a number or a yes or no, by programs not ShapeWorks
        texts_[key] = value.dump();
      else if (!value.is_null())
        not_texts_.insert(key);
    }
    find_domain();
  }

  ShapeWorksSubject read() const {
    ShapeWorksSubject subject;
    for (const char* prefix : input_prefixes)
      if (subject.shape.empty()) subject.shape = file(prefix);
    subject.groomed = file("groomed_");
    subject.local_particles = file("local_particles_");
    subject.world_particles = file("world_particles_");
    subject.alignment = transform("alignment_");
    subject.procrustes = transform("procrustes_");
    subject.name = text("name");
    if (subject.name.empty())
      subject.name = (subject.shape.empty() ? subject.local_particles : subject.shape).stem().string();
    if (subject.name.empty()) refuse("has neither a name nor a file");
    return subject;
  }

 private:
  [[noreturn]] void refuse(const std::string& found) const {
    source_.refuse(place_ + " " + found,
                   "save the project again with ShapeWorks, as .swproj, with one domain");
  }

  std::string text(const std::string& key) const {
    if (not_texts_.contains(key)) refuse("its " + io_detail::in_quotes(key) + " is no text");
    const auto found = texts_.find(key);
    return found == texts_.end() ? std::string() : found->second;
  }

  // Projects written on Windows have backslashes in paths.
  std::filesystem::path file(const std::string& prefix) const {
    std::string name = text(prefix + domain_);
    std::replace(name.begin(), name.end(), '\\', '/');
    return name;
  }

  // The name of the domain follows the prefix of a column.
  void find_domain() {
    std::set<std::string> domains;
    for (const auto& [key, value] : texts_)
      for (const std::string_view prefix : domain_prefixes)
        if (!value.empty() && key.starts_with(prefix)) domains.insert(key.substr(prefix.size()));
    if (domains.size() > 1) refuse("has " + std::to_string(domains.size()) + " domains");
    if (!domains.empty()) domain_ = *domains.begin();
  }

  Eigen::Matrix4d transform(const std::string& prefix) const {
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
    const std::string numbers = text(prefix + domain_);
    io_detail::TokenCursor words(numbers);
    std::vector<double> values;
    for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
      const auto value = io_detail::to_number(word);
      if (!value || !std::isfinite(*value))
        refuse("its " + prefix + domain_ + " holds something that is no number");
      values.push_back(*value);
    }
    constexpr std::size_t full = 16, translation = 12;
    if (values.size() == full)
      matrix = Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(values.data());
    else if (values.size() == translation)
      matrix.topRightCorner<3, 1>() = Vec3(values[9], values[10], values[11]);
    else if (!values.empty())
      refuse("its " + prefix + domain_ + " has " + std::to_string(values.size()) + " numbers, not 16");
    return matrix;
  }

  const io_detail::Source& source_;
  std::string place_, domain_ = "1";
  std::map<std::string, std::string> texts_;
  std::set<std::string> not_texts_;  // columns that matter only if they are among those that are read
};

// The sheet "data" of a spreadsheet has a row for each subject, with the same keys.
ordered_json project_in_spreadsheet(const io_detail::Source& source) {
  ordered_json data = ordered_json::array();
  for (const io_detail::SheetRow& row : io_detail::read_sheet(source, "data")) data.push_back(row);
  return {{"data", std::move(data)}};
}

}  // namespace

void write_shapeworks(const std::filesystem::path& path, std::span<const ShapeWorksSubject> subjects,
                      std::size_t particles) {
  const ordered_json none = ordered_json::object();
  ordered_json data = ordered_json::array();
  for (const ShapeWorksSubject& subject : subjects) data.push_back(json_of(subject));
  io_detail::write_json(path, {{"data", data},
                               {"groom", {{"1", none}}},
                               {"optimize", {{"number_of_particles", std::to_string(particles)}}},
                               {"studio", none},
                               {"project", none},
                               {"analysis", none},
                               {"deepssm", none},
                               {"landmarks", ordered_json::array()}});
}

std::vector<ShapeWorksSubject> read_shapeworks(const std::filesystem::path& path) {
  const std::string bytes = io_detail::read_bytes(path);
  const io_detail::Source source{path.string(), bytes};
  const ordered_json project =
      io_detail::is_zip(bytes) ? project_in_spreadsheet(source) : io_detail::parse_json(source);
  if (!project.is_object() || !project.contains("data") || !project.at("data").is_array() ||
      project.at("data").empty())
    source.refuse("has no list of subjects (\"data\")", "save the project again with ShapeWorks, as .swproj");
  std::vector<ShapeWorksSubject> subjects;
  for (const ordered_json& subject : project.at("data"))
    subjects.push_back(SubjectReader(source, subject, subjects.size()).read());
  return subjects;
}

}  // namespace foramen
