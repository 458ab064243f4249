#pragma once
/// \file
/// The common contents of files of corresponding shapes and of models.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "exchange/convert.hpp"
#include "foramen/io/statismo_file.hpp"

namespace foramen {

/// All coordinates are LPS, in mm.
struct ExchangeSet {
  std::vector<std::string> names;
  std::vector<std::vector<Vec3>> shapes;        ///< by shape, then landmark; each in its own coordinates
  std::vector<std::array<int, 3>> triangles;    ///< empty: points without triangles
  std::vector<Eigen::Matrix4d> to_common = {};  ///< one per shape, into common coordinates; empty: unknown
  std::optional<StatismoModel> model = std::nullopt;
  std::vector<Message> notes = {};
};

/// Reads everything in `request.input`. Throws InvalidInput or IoError.
ExchangeSet read_exchange_set(const ConvertRequest& request);

/// The model of the set, or a model made from its shapes. Throws InvalidInput if no model can be made.
StatismoModel model_of(const ExchangeSet& set, ScaleMode scale, const std::string& command);

/// Writes the set and returns the number of files. Throws InvalidInput if the set lacks something that the
/// format needs, and IoError.
std::size_t write_exchange_set(const ExchangeSet& set, const ConvertRequest& request, ExchangeFormat format,
                               const RunContext& ctx);

}  // namespace foramen
