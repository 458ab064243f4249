#pragma once
/// \file
/// Synthetic shapes with known correspondence, as files.

#include <filesystem>

#include "foramen/core/run_context.hpp"
#include "foramen/synth/synth_cohort.hpp"

namespace foramen {

struct SynthRequest {
  std::filesystem::path output;  ///< folder to write
  SynthOptions options = {};
};

struct SynthSummary {
  int shapes = 0;
  std::filesystem::path surfaces;  ///< OUTPUT/shapes
  std::filesystem::path truth;     ///< OUTPUT/truth, the true correspondence by the same names
};

/// Writes OUTPUT/shapes/synth001.ply, OUTPUT/truth/synth001.ply and so on. Throws what synth_cohort() throws;
/// IoError.
SynthSummary write_synth_cohort(const SynthRequest& request, const RunContext& ctx);

}  // namespace foramen
