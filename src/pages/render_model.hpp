#pragma once
/// \file
/// Pictures and curves of a model's folder, for papers, READMEs and scripts.

#include <filesystem>
#include <string>
#include <vector>

namespace foramen {

struct RenderOptions {
  std::filesystem::path baseline = {};  ///< folder of a second model for comparison; empty: none
  bool only_curves = false;  ///< needs no display, and only metrics.json and metrics.csv of the folders
};

struct RenderedFile {
  std::string name;   ///< loops.png, specificity.svg ...
  std::string bytes;  ///< contents of the file
  std::string caption;
};

/// The PNG files are loops, torus_map, overview, modes, mode1 and so on, distances_mean, distances_worst;
/// with a baseline also first_mode_beside and flips. The SVG and PDF files are the curves of every measure
/// over the number of modes, with standard errors, of both models. Throws Error if pictures are requested but
/// cannot be made, IoError if a folder lacks a file, and InvalidInput if the baseline has no shape in common
/// with the model.
std::vector<RenderedFile> render_model(const std::filesystem::path& folder,
                                       const RenderOptions& options = {});

}  // namespace foramen
