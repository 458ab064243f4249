#pragma once
/// \file
/// The files of a cohort: which ones the inputs of a command name, and what their shapes are called.

#include <filesystem>
#include <string>
#include <vector>

#include "extract/extract_labels.hpp"
#include "foramen/core/remedy.hpp"

namespace foramen {

struct ShapeFile {
  ShapeFile(std::filesystem::path file);

  std::filesystem::path path;
  /// The name of a mesh's shape and the first part of the names of a label map's shapes: the file name
  /// without extension, after FOLDER_ if a folder is set.
  std::string name;
  std::string folder;  ///< The folder that tells the files apart; empty if their names do.

  /// The file's name for records and messages, after FOLDER_ if a folder is set.
  std::string shown() const;
  /// \pre the file is a label map
  LabelMapFile label_map() const;
};

struct FoundFiles {
  std::vector<ShapeFile> files;  ///< in order of name
  std::vector<Message> notes;    ///< what was passed over
};

/// The mesh files that these inputs name. A folder stands for the files in it and in its subfolders, in
/// sorted order. Hidden files and folders are passed over, links to folders are not followed, and the
/// folder of a model (with run.json or model.h5) is not entered. Of a folder with shapes/ and truth/ only
/// shapes/ is searched. Each of this makes a note.
///
/// If two files have the same name without extension, a folder is set for all files: the nearest one that
/// tells them apart, at the same distance from each file.
///
/// Throws InvalidInput for a path that does not exist, a folder without such files, or two files of the
/// same name in one folder.
FoundFiles find_meshes(const std::vector<std::filesystem::path>& inputs);

/// As find_meshes(), for mesh files and label maps. A mesh and a label map may have the same name, because
/// the names of a label map's shapes are longer than its own. Where a folder holds masks of single
/// vertebrae (vertebrae_L1.nii.gz), its other label maps are masks of other structures and are passed over;
/// so is an image beside the folder of masks.
FoundFiles find_shape_files(const std::vector<std::filesystem::path>& inputs);
/// As find_shape_files(), for label maps.
FoundFiles find_label_maps(const std::vector<std::filesystem::path>& inputs);

/// The file whose shape has that name: by its own name, else as FOLDER_STEM with a folder above it, as
/// another cohort of the same files may have named it. Null if there is none or more than one.
const ShapeFile* file_named(const std::vector<ShapeFile>& files, const std::string& name);

/// The inputs as a record names them, without the folders of this machine: the shown() of a file, the own
/// name of a folder.
std::vector<std::string> words_of_inputs(const std::vector<std::string>& inputs,
                                         FoundFiles (*find)(const std::vector<std::filesystem::path>&));

}  // namespace foramen
