#pragma once
/// \file
/// Random shapes of a model, from files to files.

#include <cstdint>
#include <filesystem>
#include <vector>

#include "foramen/core/remedy.hpp"
#include "foramen/core/run_context.hpp"

namespace foramen {

struct SampleRequest {
  std::filesystem::path model;   ///< a model's folder, or its model.h5
  std::filesystem::path output;  ///< folder to write
  int count = 10;
  std::uint64_t seed = 1;
};

/// Writes sample0001.ply and so on, in model coordinates, and returns the notes on how the model was read.
/// Throws IoError.
std::vector<Message> sample_model(const SampleRequest& request, const RunContext& ctx);

}  // namespace foramen
