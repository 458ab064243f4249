#pragma once
/// \file
/// The folder of a model as pictures and curves, for papers, READMEs and scripts.

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace foramen {

struct RenderOptions {
  std::filesystem::path baseline = {};  ///< folder of a model to be seen beside; empty: none
  bool only_curves = false;             ///< needs no display, and of the folders metrics.json and metrics.csv
};

struct RenderedFile {
  std::string name;   ///< loops.png, specificity.svg ...
  std::string bytes;  ///< of the file
  std::string caption;
};

/// PNG: loops, torus_map, overview, modes (a plate), mode1 ..., distances_mean, distances_worst; with a
/// baseline first_mode_beside and flips. SVG and PDF: the curves of every measure over the number of modes,
/// with standard errors, of both models. Throws Error where pictures are wanted and none can be made, IoError
/// if a folder lacks a file, InvalidInput if the baseline has no shape in common with the model.
std::vector<RenderedFile> render_model(const std::filesystem::path& folder,
                                       const RenderOptions& options = {});

/// The files in a folder, which is made if need be; returns their captions by their names.
nlohmann::ordered_json write_rendered(const std::vector<RenderedFile>& files,
                                      const std::filesystem::path& folder);

}  // namespace foramen
