#include "io/mark_file.hpp"

#include "foramen/core/error.hpp"
#include "io/json_text.hpp"
#include "io/mark_formats.hpp"
#include "io/scalismo_landmarks.hpp"

namespace foramen {
namespace {

using io_detail::lower_case;

MarkFile marks_of(const std::vector<ScalismoLandmark>& landmarks) {
  NamedMarks of_shape;
  for (const ScalismoLandmark& landmark : landmarks)
    of_shape.marks.push_back({landmark.id, MarkKind::point, {landmark.position}});
  return {{std::move(of_shape)}, {}};
}

MarkFile read_json(const std::filesystem::path& path) {
  const std::string bytes = io_detail::read_bytes(path);
  const io_detail::Source source{path.string(), bytes};
  const nlohmann::ordered_json json = io_detail::parse_json(source);
  if (json.is_array()) return marks_of(read_scalismo_landmarks(path));
  if (!json.is_object() || !json.contains("markups"))
    source.refuse("is neither a list of landmarks (Scalismo) nor an object with 'markups' (Slicer)",
                  "save the marks again in one of these formats");
  return io_detail::parse_slicer_markups(source, json);
}

}  // namespace

namespace io_detail {

AnatomicalSpace space_named(const Source& source, std::string_view word) {
  const std::string name = lower_case(word);
  // Old files of Slicer number the spaces.
  if (name == "lps" || name == "1") return AnatomicalSpace::lps;
  if (name == "ras" || name == "0") return AnatomicalSpace::ras;
  source.refuse("its coordinate system " + in_quotes(word) + " is neither LPS nor RAS",
                "save it in one of these");
}

}  // namespace io_detail

bool is_mark_file(const std::filesystem::path& path) {
  const std::string extension = lower_case(path.extension().string());
  return extension == ".json" || extension == ".fcsv" || extension == ".csv";
}

std::string mark_stem(const std::filesystem::path& path) {
  const std::filesystem::path stem = path.stem();
  return (lower_case(stem.extension().string()) == ".mrk" ? stem.stem() : stem).string();
}

MarkFile read_mark_file(const std::filesystem::path& path) {
  const std::string extension = lower_case(path.extension().string());
  if (extension == ".json") return read_json(path);
  if (extension == ".csv") return io_detail::read_mark_table(path);
  if (extension == ".fcsv") {
    const std::string bytes = io_detail::read_bytes(path);
    return io_detail::parse_fcsv({path.string(), bytes});
  }
  throw IoError(path.string() +
                ": is no file of marks; give .mrk.json or .fcsv of Slicer, .json of Scalismo or .csv");
}

}  // namespace foramen
