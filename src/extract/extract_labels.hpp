#pragma once
/// \file
/// The surfaces of all wanted labels of one label map.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "extract/label_request.hpp"
#include "extract/name_labels.hpp"
#include "foramen/core/remedy.hpp"
#include "foramen/core/run_context.hpp"

namespace foramen {

/// A label map on disk and the first parts of the names of its shapes.
struct LabelMapFile {
  LabelMapFile(std::filesystem::path file);

  std::filesystem::path path;
  std::string stem;  ///< the file name without extension
  /// The same if the file is the mask of one vertebra: what its name holds besides the level, or, if this
  /// is nothing, the patient's folder: s0001 for s0001/segmentations/vertebrae_L1.nii.gz.
  std::string mask_stem;
};

/// Whether a folder of that name tells only what kind of files it holds: "segmentations", "masks" ...
bool is_kind_of_files(const std::string& folder);

/// The nearest folder above the file that is no is_kind_of_files(). Empty if there is none.
std::string patient_folder(const std::filesystem::path& file);

struct LabelSurface {
  int label = 0;
  std::string name;  ///< e.g. "L1"
  std::string stem;  ///< file name without extension, _ and the name, e.g. "verse004_L1"
  ExtractedSurface extracted;
};

/// A wanted label for which no surface was extracted, and why.
struct RefusedLabel {
  int label = 0;
  std::string name, stem;
  Message reason;
  bool absent = false;  ///< named singly and not in the label map
};

struct LabelSurfaces {
  std::string sha256;                  ///< of the label map, see LabelMap
  std::vector<LabelSurface> surfaces;  ///< in order of label
  std::vector<RefusedLabel> refused;   ///< the same
  std::vector<Message> notes;          ///< what the user should know though it is no error
  std::string names_from;              ///< how the labels got their names, see LabelNaming::origin()
  bool assumed = false;                ///< nothing told the numbering of the labels that were taken
  /// Set if the file is a mask of one structure that was not wanted or is empty: why nothing was taken.
  std::optional<std::string> passed_over = std::nullopt;
};

/// Reads the label map, each layer of it, and extracts the surfaces of its labels in parallel. A wanted
/// label that is absent is refused if it was named singly; if it belongs to a range, a note is made. The
/// mask of one vertebra, see NameSource::file_name, is wanted if its own label or the number of its level
/// is. Throws IoError as read_label_layers() does, and InvalidInput if the map contains none of the wanted
/// labels.
LabelSurfaces extract_labels(const LabelMapFile& file, const LabelRequest& request, const RunContext& ctx);

}  // namespace foramen
