#pragma once
/// \file
/// What files of corresponding shapes and of models have in common.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "exchange/convert.hpp"
#include "foramen/io/statismo_file.hpp"

namespace foramen {

/// LPS mm throughout.
struct ExchangeSet {
  std::vector<std::string> names;
  std::vector<std::vector<Vec3>> shapes;        ///< by shape, then landmark; each in its own coordinates
  std::vector<std::array<int, 3>> triangles;    ///< empty: points alone
  std::vector<Eigen::Matrix4d> to_common = {};  ///< one a shape, into common coordinates; empty: not known
  std::optional<StatismoModel> model = std::nullopt;
  std::vector<Message> notes = {};
};

/// Everything that `request.input` holds. Throws InvalidInput, IoError.
ExchangeSet read_exchange_set(const ConvertRequest& request);

/// The model, or one of the shapes. Throws InvalidInput if it cannot be made.
StatismoModel model_of(const ExchangeSet& set, ScaleMode scale, const std::string& command);

/// Number of files written. Throws InvalidInput if the set has not what the format needs, IoError.
std::size_t write_exchange_set(const ExchangeSet& set, const ConvertRequest& request, ExchangeFormat format,
                               const RunContext& ctx);

}  // namespace foramen
