#pragma once
/// \file
/// Options and files that `synth` and `demo` share.

#include <filesystem>
#include <string>
#include <vector>

#include "command.hpp"
#include "foramen/synth/synth_cohort.hpp"

namespace foramen::app {

void add_synth_options(CLI::App& command, SynthOptions& options);
/// synth001, synth002 ...
std::string synth_name(int index);
/// FOLDER/shapes/synthNNN.ply and FOLDER/truth/synthNNN.ply.
void write_synth_cohort(const std::vector<SynthShape>& shapes, const std::filesystem::path& folder);

}  // namespace foramen::app
