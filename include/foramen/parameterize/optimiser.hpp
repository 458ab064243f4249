#pragma once
/// \file
/// How the energy of a torus map is minimised.

#include <string_view>
#include <utility>

#include "foramen/core/options.hpp"

namespace foramen {

enum class Optimiser {
  newton,         ///< projected Newton over all vertices at once
  polak_ribiere,  ///< the paper's node-wise conjugate gradients
};
template <>
struct EnumWords<Optimiser> {
  static constexpr std::pair<std::string_view, Optimiser> all[] = {
      {"newton", Optimiser::newton}, {"polak-ribiere", Optimiser::polak_ribiere}};
};

/// How triangles and vertices are weighted: `area`: by their share of the surface (an area-weighted mean,
/// independent of the triangulation); `each`: sum over vertices of E_cor + lambda sum over triangles of E,
/// the paper's form (eq. 4).
enum class Weighting { area, each };
template <>
struct EnumWords<Weighting> {
  static constexpr std::pair<std::string_view, Weighting> all[] = {{"area", Weighting::area},
                                                                   {"each", Weighting::each}};
};

}  // namespace foramen
