#pragma once
/// \file
/// run.json: how a model was made, from what, and what became of every shape.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "foramen/extract/extract_label.hpp"
#include "foramen/stages/build_model.hpp"
#include "modelfiles/json_fields.hpp"
#include "modelfiles/repair_record.hpp"

namespace foramen {

/// The options of a build.
class RunOptions {
 public:
  RunOptions() = default;
  /// Throws InvalidInput if one of those that have a name here is missing.
  explicit RunOptions(nlohmann::ordered_json by_name);

  Method method() const { return method_; }
  /// "surface", "neighbours" or "description"; unset: the method has none.
  const std::optional<std::string>& objective() const { return objective_; }
  ScaleMode scale() const { return scale_; }
  /// All options by their names. Which there are depends on the version that made the model.
  const nlohmann::ordered_json& by_name() const { return by_name_; }

 private:
  nlohmann::ordered_json by_name_ = nlohmann::ordered_json::object();
  Method method_ = Method::torus;
  std::optional<std::string> objective_ = std::nullopt;
  ScaleMode scale_ = ScaleMode::keep;
};

/// A surface that was given.
struct RunInput {
  std::string file = {}, sha256 = {};
  std::optional<int> vertices = std::nullopt, triangles = std::nullopt;  ///< unset: the shape was left out
  std::optional<int> label = std::nullopt;                               ///< of a label map
  /// How the label got its name: "verse, assumed", "the names in the file" ... Unset as the label.
  std::optional<std::string> names_from = std::nullopt;
  /// Of a label whose surface is used. run.json has no means of its deviations; they are 0 when read.
  std::optional<ExtractionReport> extraction = std::nullopt;
};

/// The proof that a map is one to one, with the loops it takes to each other.
struct RunCertificate {
  std::string mesh = "input";  ///< whose triangles are meant
  int triangles = 0, flipped = 0;
  double smallest_area_ratio = 0, largest_area_ratio = 0, degree = 0;  ///< see MapCertificate
  Eigen::Matrix2i homology = Eigen::Matrix2i::Zero();                  ///< see ShapeRegistration
  Eigen::Matrix2i seifert = Eigen::Matrix2i::Zero(), reference_seifert = Eigen::Matrix2i::Zero();
  Vec2 agreement = Vec2::Zero();  ///< see map_agreement()
};

/// How a shape was mapped.
struct RunMap {
  int iterations = 0;
  double initial_energy = 0, final_energy = 0;
  double distortion = 0;
  RunCertificate certificate = {};
};

/// What is known of a shape that is part of the model.
struct UsedShape {
  double seconds = 0;
  double alignment_residual_mm = 0;
  std::optional<RepairRecord> repair = std::nullopt;           ///< unset: the surface was used as it is
  std::optional<RunMap> map = std::nullopt;                    ///< unset: the method maps the reference alone
  std::optional<int> without_compatible_point = std::nullopt;  ///< landmarks; set where there is no map
  std::optional<int> flips_in_map = std::nullopt;              ///< unset: there is no map
  int plain_flips = 0, confirmed_flips = 0, opposing_mean = 0;  ///< see ShapeRepresentation
  int self_intersections = 0, input_self_intersections = 0;     ///< the same
};

enum class ShapeStatus { used, reference, left_out };
template <>
struct EnumWords<ShapeStatus> {
  static constexpr std::pair<std::string_view, ShapeStatus> all[] = {{"used", ShapeStatus::used},
                                                                     {"reference", ShapeStatus::reference},
                                                                     {"left out", ShapeStatus::left_out}};
};

struct RunShape {
  std::string name = {};
  ShapeStatus status = ShapeStatus::used;
  std::string reason = {};                       ///< why it was left out, or what was changed; may be empty
  std::optional<UsedShape> used = std::nullopt;  ///< set unless it was left out
};

struct RunRecord {
  std::string version = {}, command = {};
  RunOptions options = {};
  std::uint64_t seed = 0;
  std::vector<RunInput> inputs = {};
  std::string reference = {};                   ///< name of the shape
  std::vector<double> template_motion_mm = {};  ///< this and the next two: see GroupRegistration
  std::vector<double> unexplained_shares = {}, description_lengths = {};
  int landmarks = 0;
  int landmarks_inserted = 0;
  int self_intersections_before_mending = 0, self_intersections_not_mended = 0;
  int landmark_triangles = 0;
  std::vector<RunShape> shapes = {};
  double seconds = 0;  ///< this and what follows differs from run to run
  NamedNumbers seconds_by_stage = {};
  int threads = 0;
  int stages_taken_up = 0;
  double peak_memory_mb = 0;
};

/// The contents of run.json.
std::string run_json(const RunRecord& record);
/// The way back. What a file of an earlier version may lack stays at its default. Throws IoError, which calls
/// the text by this name and says which part of it is wrong.
RunRecord parse_run(const std::string& text, const std::string& name);

/// Reads FOLDER/run.json. Throws IoError.
RunRecord read_run(const std::filesystem::path& folder);

}  // namespace foramen
