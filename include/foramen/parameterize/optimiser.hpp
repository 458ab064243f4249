#pragma once
/// \file
/// How the energy of a torus map is minimised.

#include <string_view>
#include <utility>

#include "foramen/core/options.hpp"

namespace foramen {

/// The method of minimisation.
enum class Optimiser {
  newton,         ///< projected Newton over all vertices at once
  polak_ribiere,  ///< the paper's node-wise conjugate gradients
};
template <>
struct EnumWords<Optimiser> {
  static constexpr std::pair<std::string_view, Optimiser> all[] = {
      {"newton", Optimiser::newton}, {"polak-ribiere", Optimiser::polak_ribiere}};
};

/// Weights of triangles and vertices in the energy. With `area` they are shares of the surface area, so the
/// energy is an area-weighted mean that does not depend on the triangulation. With `each` the energy is sum
/// over vertices of E_cor + lambda sum over triangles of E, the form of the paper (eq. 4).
enum class Weighting { area, each };
template <>
struct EnumWords<Weighting> {
  static constexpr std::pair<std::string_view, Weighting> all[] = {{"area", Weighting::area},
                                                                   {"each", Weighting::each}};
};

}  // namespace foramen
