#pragma once
/// \file
/// The pictures and curves of a model, as files.

#include <filesystem>
#include <string>
#include <vector>

#include "pages/render_model.hpp"

namespace foramen {

struct PicturesRequest {
  std::filesystem::path model;   ///< a model's folder
  std::filesystem::path output;  ///< folder to write
  RenderOptions render = {};
};

struct WrittenPicture {
  std::filesystem::path file;
  std::string caption;
};

/// Writes what render_model() makes, in its order. Throws what it throws; IoError.
std::vector<WrittenPicture> write_pictures(const PicturesRequest& request);

}  // namespace foramen
