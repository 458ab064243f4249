#pragma once
/// \file
/// Registration of new surfaces to the mean of a finished model.

#include <memory>
#include <span>
#include <vector>

#include "foramen/core/run_context.hpp"
#include "foramen/correspond/registration_frame.hpp"
#include "foramen/correspond/registration_options.hpp"

namespace foramen {

/// Registers surfaces to the mean of a model, which replaces both the reference and the template. The
/// shortest loops of the mean are found, and its torus map is expressed in their basis. A mean of fewer than
/// 1000 landmarks is subdivided for this. One registrar serves any number of surfaces; const calls may run in
/// parallel.
class MeanRegistrar {
 public:
  /// \param mean  the mean with its landmarks as vertices, and its map to the torus
  /// \param training  landmarks of the model's shapes in model coordinates, mm; the prior of a new surface's
  /// displacement is learnt from them (CohortPriors::of_newcomer())
  ///
  /// Throws TopologyError if the mean is not closed and of genus 1; InvalidInput for sizes that do not agree.
  MeanRegistrar(const TemplateSurface& mean, std::span<const std::vector<Vec3>> training,
                const RunContext& ctx, const RegisterGroupOptions& options = {});
  ~MeanRegistrar();
  MeanRegistrar(MeanRegistrar&&) noexcept;
  MeanRegistrar& operator=(MeanRegistrar&&) noexcept;

  /// The landmarks on a closed surface of genus 1 in any pose, in the coordinates of the surface, mm. The
  /// surface is registered like a member of a group in register_group(), with one round and with all checks.
  /// Runs on one thread. Throws TopologyError or ConvergenceError with the reason if a check fails.
  std::vector<Vec3> landmarks_on(const Mesh& surface, const RunContext& ctx) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace foramen
