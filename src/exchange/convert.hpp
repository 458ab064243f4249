#pragma once
/// \file
/// Conversion of models and corresponding shapes between the file formats of different tools.

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

/// The formats that can be written. All have lengths in mm and LPS axes. Each line names the programs that
/// read the format.
enum class ExchangeFormat {
  statismo,            ///< OUTPUT.h5: the model; statismo, Scalismo
  scalismo_json,       ///< OUTPUT.h5.json: the model as JSON; Scalismo
  shapeworks,          ///< OUTPUT.swproj, with groomed/NAME.ply and particles/ beside it; ShapeWorks
  tps,                 ///< OUTPUT.tps: the landmarks of all shapes; R (geomorph, Morpho)
  landmark_table,      ///< OUTPUT.csv: shape, landmark, x, y, z
  score_table,         ///< OUTPUT.csv: scores of the shapes on the modes of model.h5, in standard deviations
  ply,                 ///< OUTPUT/NAME.ply: one mesh per shape
  vtp,                 ///< OUTPUT/NAME.vtp: one mesh per shape
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
  /// (.swproj, .xlsx), .tps, or a landmark table (.csv).
  std::filesystem::path input;
  std::filesystem::path output;
  std::optional<ExchangeFormat> format = std::nullopt;  ///< unset: by the extension; ply for a folder
  InputUnit unit = {};                                  ///< unit of the shapes in the input; models are in mm
  std::filesystem::path triangles = {};  ///< a mesh whose triangles are used for points without triangles
  ScaleMode scale = ScaleMode::keep;     ///< for the alignment, if a model is made from shapes
  std::string command = {};              ///< recorded in models
};

struct ConvertSummary {
  ExchangeFormat format;
  std::size_t shapes = 0, landmarks = 0, files = 0;
  std::vector<Message> notes;  ///< what the user should know though it is no error
};

/// Reads the whole input before it writes. Each file is written whole or not at all, and a file that names
/// others is written last. Shapes keep their own coordinates, except that RAS axes are converted to LPS (x
/// and y change sign); each mesh's SPACE tag says which axes it has, and the tag of mean.ply says it for a
/// model of a build. The training shapes of a model are reconstructed from their scores, in the model's
/// coordinates. Shapes are converted to a model by Procrustes alignment and PCA with equal landmark weights.
/// Throws InvalidInput if the input lacks something that the output needs, if two shapes have the same name,
/// if the output folder holds other files, or if the output lies in the input's folder. Throws IoError if a
/// file cannot be read or written.
ConvertSummary convert(const ConvertRequest& request, const RunContext& ctx);

}  // namespace foramen
