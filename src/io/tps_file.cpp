#include <array>
#include <cmath>
#include <utility>

#include "foramen/core/error.hpp"
#include "io/atomic_file.hpp"
#include "io/named_points_text.hpp"

namespace foramen {
namespace {

using io_detail::in_quotes;
using io_detail::lower_case;
using io_detail::to_number;

// Other readers search whole lines for these words, in upper and lower case, and drop lines that have them.
constexpr std::array words_readers_drop{"=", "comment=", "curves=", "variables", "chain", "radii", "scale"};

void check_name(const std::filesystem::path& path, const std::string& name) {
  const auto refuse = [&](const std::string& what) {
    throw InvalidInput("cannot write " + path.string() + ": the name " + in_quotes(name) + " " + what +
                       "; rename the shape");
  };
  if (name.empty() || name.find_first_of("\r\n") != std::string::npos) refuse("is empty or has a line break");
  for (const char* word : words_readers_drop)
    if (lower_case(name).find(word) != std::string::npos)
      refuse("has '" + std::string(word) + "' in it, which readers of TPS take for something else");
}

class TpsParser {
 public:
  explicit TpsParser(const io_detail::Source& source) : source_(source), lines_(source.bytes) {}

  TpsFile parse() {
    while (lines_.next_filled()) parse_line(lines_.line());
    finish_specimen();
    apply_scales();
    TpsFile file;
    leave_out_incomplete(file);
    io_detail::check_read(source_, file.specimens);
    if (curves_ > 0) file.notes.push_back(std::to_string(curves_) + " curves were left out");
    return file;
  }

 private:
  [[noreturn]] void refuse(const std::string& found, const std::string& remedy) const {
    source_.refuse(lines_.place() + ": " + found, remedy);
  }

  void parse_line(std::string_view line) {
    const auto equals = line.find('=');
    if (equals == std::string_view::npos)
      refuse("expected KEY=value, found " + in_quotes(line), number_remedy);
    const std::string key = lower_case(io_detail::TokenCursor(line.substr(0, equals)).rest());
    const std::string_view value = io_detail::TokenCursor(line.substr(equals + 1)).rest();
    if (key == "lm3" || key == "lm")
      read_points(value);
    else if (key == "points")
      pass_over_curve(value);
    else if (specimens_.empty())
      return;  // a comment before the first specimen
    else if (key == "id")
      specimens_.back().name = value;
    else if (key == "image")
      image_ = std::filesystem::path(value).stem().string();
    else if (key == "scale")
      read_scale(value);
  }

  // The number of points that follow. Each takes at least four bytes (three in the last line), so memory is
  // allocated only for points that the file can hold.
  std::int64_t point_count(std::string_view value) const {
    const auto count = io_detail::to_integer(value);
    if (!count || *count < 0 || static_cast<std::uint64_t>(*count) > lines_.remaining() / 3)
      refuse(in_quotes(value) + " is no number of points that could follow", io_detail::remedy_export_again);
    return *count;
  }
  void next_point_line() {
    if (!lines_.next_filled()) refuse("the file ends within a specimen", io_detail::remedy_export_again);
  }

  // Programs without landmarks for an image write LM=0 for it.
  void read_points(std::string_view value) {
    finish_specimen();
    const std::int64_t count = point_count(value);
    specimens_.emplace_back();
    incomplete_.push_back(count == 0);
    for (std::int64_t i = 0; i < count; ++i) {
      next_point_line();
      const auto point = io_detail::point_of(lines_.line());
      if (point)
        specimens_.back().points.push_back(*point);
      else if (is_missing_point(lines_.line()))
        incomplete_.back() = true;
      else
        refuse_point(lines_.line());
    }
  }

  // Three words of which one or more are NA, NaN or ? and the others numbers.
  static bool is_missing_point(std::string_view line) {
    io_detail::TokenCursor words(line);
    bool missing = false;
    for (int k = 0; k < 3; ++k) {
      const std::string word = lower_case(words.next());
      const bool is_mark = word == "na" || word == "nan" || word == "?";
      if (!is_mark && !to_number(word)) return false;
      missing = missing || is_mark;
    }
    return missing && words.rest().empty();
  }

  [[noreturn]] void refuse_point(std::string_view line) const {
    io_detail::TokenCursor words(line);
    const bool two = to_number(words.next()) && to_number(words.next()) && words.rest().empty();
    if (two) refuse("two-dimensional landmarks", "only those with three coordinates (LM3=) are read");
    refuse("expected three numbers, found " + in_quotes(line), number_remedy);
  }

  void pass_over_curve(std::string_view value) {
    const std::int64_t count = point_count(value);
    for (std::int64_t i = 0; i < count; ++i) next_point_line();
    ++curves_;
  }

  // A shape with missing points does not correspond to the others.
  void leave_out_incomplete(TpsFile& file) {
    std::string names;
    std::size_t count = 0;
    constexpr std::size_t most_named = 5;
    for (std::size_t i = 0; i < specimens_.size(); ++i)
      if (!incomplete_[i])
        file.specimens.push_back(std::move(specimens_[i]));
      else if (++count <= most_named)
        names += (names.empty() ? "" : ", ") + specimens_[i].name;
    if (count > most_named) names += ", ...";
    if (count > 0 && file.specimens.empty())
      source_.refuse("points are missing in every specimen (" + names + ")", "estimate missing points first");
    if (count > 0)
      file.notes.push_back(std::to_string(count) + " of " + std::to_string(specimens_.size()) +
                           " specimens have missing points and were left out: " + names);
  }

  void read_scale(std::string_view value) {
    const auto scale = to_number(value);
    if (!scale || !(*scale > 0 && std::isfinite(*scale)))
      refuse("SCALE=" + in_quotes(value) + " is no positive number", "correct it");
    scales_.resize(specimens_.size(), 0);
    scales_.back() = *scale;
  }

  void finish_specimen() {
    if (specimens_.empty()) return;
    std::string& name = specimens_.back().name;
    if (name.empty()) name = image_.empty() ? "specimen" + std::to_string(specimens_.size()) : image_;
    image_.clear();
  }

  // Either all specimens have a scale or none has, since otherwise some would be in mm and some in pixels.
  void apply_scales() {
    if (scales_.empty()) return;
    scales_.resize(specimens_.size(), 0);
    for (std::size_t i = 0; i < specimens_.size(); ++i) {
      if (scales_[i] == 0)
        source_.refuse(in_quotes(specimens_[i].name) + " has no SCALE=, others have",
                       "give it to all or none");
      for (Vec3& point : specimens_[i].points) point *= scales_[i];
    }
  }

  static constexpr const char* number_remedy = "correct the line, and check the number after LM3=";
  const io_detail::Source& source_;
  io_detail::LineCursor lines_;
  std::vector<NamedPoints> specimens_;
  std::vector<bool> incomplete_;  // by specimen
  std::vector<double> scales_;    // 0: no scale
  std::size_t curves_ = 0;
  std::string image_;
};

}  // namespace

void write_tps(const std::filesystem::path& path, std::span<const NamedPoints> specimens) {
  io_detail::check_specimens(path, specimens);
  std::string out;
  for (const NamedPoints& specimen : specimens) {
    check_name(path, specimen.name);
    out += "LM3=" + std::to_string(specimen.points.size()) + "\n";
    for (const Vec3& point : specimen.points) out += io_detail::text_of(point) + "\n";
    out += "ID=" + specimen.name + "\n";
  }
  write_file(path, out);
}

TpsFile read_tps(const std::filesystem::path& path) {
  const std::string bytes = io_detail::read_bytes(path);
  const io_detail::Source source{path.string(), bytes};
  return TpsParser(source).parse();
}

}  // namespace foramen
