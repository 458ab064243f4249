#include "io/vertex_labels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "foramen/core/error.hpp"
#include "io/mesh_formats.hpp"

namespace foramen {
namespace {

using io_detail::lower_case;
using io_detail::Source;

constexpr std::array label_names{"label", "labels", "region", "regions", "segment", "scalars"};
constexpr std::array other_names{"nx", "ny", "nz", "red",       "green",     "blue",    "alpha", "s",
                                 "t",  "u",  "v",  "texture_u", "texture_v", "quality", "flags"};

std::vector<int> parse_lines(const Source& source) {
  std::vector<int> labels;
  io_detail::LineCursor lines(source.bytes);
  while (lines.next_filled()) {
    const std::string_view text = io_detail::TokenCursor(lines.line()).rest();
    const auto label = io_detail::to_integer(text);
    if (!label || !std::in_range<int>(*label))
      source.refuse(lines.place() + ": expected a whole number, found " + io_detail::in_quotes(text),
                    "give the label of one vertex a line");
    labels.push_back(static_cast<int>(*label));
  }
  return labels;
}

std::vector<int> whole_numbers(const Source& source, const VertexScalar& scalar) {
  std::vector<int> labels;
  labels.reserve(scalar.values.size());
  for (const double value : scalar.values) {
    const bool whole = value == std::round(value) && std::abs(value) <= std::numeric_limits<int>::max();
    if (!whole)
      source.refuse("its field '" + scalar.name + "' has the value " + std::to_string(value) + " at vertex " +
                        std::to_string(labels.size()),
                    "labels are whole numbers");
    labels.push_back(static_cast<int>(value));
  }
  return labels;
}

std::vector<int> labels_among(const Source& source, const std::vector<VertexScalar>& scalars) {
  std::vector<const VertexScalar*> candidates;
  std::string names;
  for (const VertexScalar& scalar : scalars) {
    const std::string name = lower_case(scalar.name);
    if (std::find(label_names.begin(), label_names.end(), name) != label_names.end())
      return whole_numbers(source, scalar);
    if (std::find(other_names.begin(), other_names.end(), name) != other_names.end()) continue;
    candidates.push_back(&scalar);
    names += (names.empty() ? "'" : ", '") + scalar.name + "'";
  }
  if (candidates.empty()) source.refuse("its vertices have no labels", "save them as a field named 'label'");
  if (candidates.size() > 1)
    source.refuse("its vertices have the fields " + names, "rename the one with the labels 'label'");
  return whole_numbers(source, *candidates.front());
}

}  // namespace

bool is_label_list(const std::filesystem::path& path) {
  const std::string extension = lower_case(path.extension().string());
  return extension == ".txt" || extension == ".ply" || extension == ".vtk" || extension == ".vtp";
}

std::vector<int> read_vertex_labels(const std::filesystem::path& path) {
  const std::string extension = lower_case(path.extension().string());
  if (!is_label_list(path))
    throw IoError(path.string() + ": is no file of labels; give .txt, .ply, .vtk or .vtp");
  const std::string bytes = io_detail::read_bytes(path);
  const Source source{path.string(), bytes};
  if (extension == ".txt") return parse_lines(source);
  if (extension == ".ply") return labels_among(source, io_detail::parse_ply_scalars(source));
  return labels_among(source, extension == ".vtk" ? io_detail::parse_vtk_scalars(source)
                                                  : io_detail::parse_vtp_scalars(source));
}

}  // namespace foramen
