#pragma once
/// \file
/// Models and corresponding shapes from one tool's files to another's.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "foramen/core/options.hpp"
#include "foramen/core/run_context.hpp"
#include "foramen/core/units.hpp"
#include "foramen/model/procrustes.hpp"

namespace foramen {

/// What can be written. Lengths are in mm and axes LPS in all of them.
enum class ExchangeFormat {
  statismo,            ///< OUTPUT.h5: the model; statismo, Scalismo
  scalismo_json,       ///< OUTPUT.h5.json: the same as JSON; Scalismo
  shapeworks,          ///< OUTPUT.swproj, with groomed/NAME.ply and particles/ beside it; ShapeWorks
  tps,                 ///< OUTPUT.tps: the landmarks of all shapes; R (geomorph, Morpho)
  landmark_table,      ///< OUTPUT.csv: shape, landmark, x, y, z
  score_table,         ///< OUTPUT.csv: scores of the shapes on the modes of model.h5, in standard deviations
  ply,                 ///< OUTPUT/NAME.ply: a mesh a shape
  vtp,                 ///< OUTPUT/NAME.vtp
  scalismo_landmarks,  ///< OUTPUT/NAME.json: the landmarks of a shape; Scalismo
};

template <>
struct EnumWords<ExchangeFormat> {
  static constexpr std::pair<std::string_view, ExchangeFormat> all[] = {
      {"h5", ExchangeFormat::statismo},
      {"h5.json", ExchangeFormat::scalismo_json},
      {"swproj", ExchangeFormat::shapeworks},
      {"tps", ExchangeFormat::tps},
      {"csv", ExchangeFormat::landmark_table},
      {"scores", ExchangeFormat::score_table},
      {"ply", ExchangeFormat::ply},
      {"vtp", ExchangeFormat::vtp},
      {"landmarks", ExchangeFormat::scalismo_landmarks}};
};

struct ConvertRequest {
  /// A model's folder, model.h5, model.h5.json, a folder of corresponding meshes, a ShapeWorks project
  /// (.swproj), .tps, or a landmark table (.csv).
  std::filesystem::path input;
  std::filesystem::path output;
  std::optional<ExchangeFormat> format = std::nullopt;  ///< unset: by the output's extension; a folder: ply
  LengthUnit unit = LengthUnit::millimetre;             ///< of the shapes in the input; models are in mm
  std::filesystem::path triangles = {};  ///< a mesh with the triangles of shapes that come as points alone
  ScaleMode scale = ScaleMode::keep;     ///< where shapes are aligned to make a model of them
  std::string command = {};              ///< recorded in models
};

struct ConvertSummary {
  ExchangeFormat format;
  std::size_t shapes = 0, landmarks = 0, files = 0;
  std::vector<Message> notes;  ///< what the user should know though it is no error
};

/// Reads all, then writes; each file whole or not at all, and what names others last. Shapes stay in their
/// own coordinates but for the axes: RAS is turned to LPS (x and y change sign), by each mesh's SPACE tag and
/// by a build's mean.ply. A model gives its training shapes by their scores, in the model's coordinates.
/// Shapes give a model by Procrustes alignment and PCA (all landmarks alike). Throws InvalidInput if the
/// input has not what the output needs, if names cannot be told apart, if the output folder holds other
/// files, or if the output lies in the input's folder; IoError.
ConvertSummary convert(const ConvertRequest& request, const RunContext& ctx);

}  // namespace foramen
