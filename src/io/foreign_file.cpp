#include "io/foreign_file.hpp"

#include <array>
#include <fstream>

namespace foramen::io_detail {
namespace {

constexpr const char* remedy_surface = "convert it to a surface in PLY, STL, OBJ, OFF, VTK or VTP";
constexpr const char* remedy_unpack = "unpack it and give the files in it";
constexpr const char* remedy_picture = "give a label map (NIfTI, NRRD, MetaImage) or a surface";
constexpr const char* remedy_matlab =
    "write its volume as NIfTI (niftiwrite) or its surface as STL (stlwrite) in MATLAB";

struct Kind {
  std::size_t at;  // of the mark in the file
  std::string_view mark;
  const char* name;
  const char* remedy;
};

using namespace std::string_view_literals;

constexpr std::array kinds{
    Kind{0, "PK\3\4"sv, "a zip archive (also .xlsx, .3mf, .kmz)", remedy_unpack},
    Kind{0, "7z\xbc\xaf\x27\x1c"sv, "a 7z archive", remedy_unpack},
    Kind{0, "Rar!\x1a\7"sv, "a rar archive", remedy_unpack},
    Kind{0,
         "\xfd"
         "7zXZ"sv,
         "a file packed by xz", remedy_unpack},
    Kind{0, "BZh"sv, "a file packed by bzip2", remedy_unpack},
    Kind{0, "\x28\xb5\x2f\xfd"sv, "a file packed by zstd", remedy_unpack},
    Kind{257, "ustar"sv, "a tar archive", remedy_unpack},
    Kind{0, "\x89PNG\r\n"sv, "a picture (PNG)", remedy_picture},
    Kind{0, "\xff\xd8\xff"sv, "a picture (JPEG)", remedy_picture},
    Kind{0, "GIF8"sv, "a picture (GIF)", remedy_picture},
    Kind{0, "II*\0"sv, "a picture (TIFF)", remedy_picture},
    Kind{0, "MM\0*"sv, "a picture (TIFF)", remedy_picture},
    Kind{0, "%PDF-"sv, "a document (PDF)", remedy_picture},
    Kind{0, "MATLAB 5.0 MAT-file"sv, "a MATLAB file", remedy_matlab},
    Kind{0, "MATLAB 7.3 MAT-file"sv, "a MATLAB file", remedy_matlab},
    Kind{0, "\x89HDF\r\n"sv, "an HDF5 file", "if it is a model, give it to a command that takes models"},
    Kind{0, "ISO-10303-21;"sv, "a STEP file of CAD",
         "tessellate it and save it as STL, e.g. by FreeCAD or Gmsh"},
    Kind{0, "\xd0\xcf\x11\xe0"sv, "a file of Office, of an old version or with a password",
         "save it in a newer format without a password"},
    Kind{0, "BLENDER"sv, "a Blender scene", "export the surface from Blender as PLY or STL"},
    Kind{0, "glTF\2"sv, "a glTF scene", remedy_surface},
    Kind{0, "Kaydara FBX"sv, "an FBX scene", remedy_surface},
    Kind{0, "\xff\xff\xfe"sv, "a FreeSurfer surface", "convert it to STL by mris_convert"},
    Kind{0, "version https://git-lfs"sv, "only a pointer of Git LFS",
         "fetch the file itself by 'git lfs pull'"},
    Kind{0, "\xff\xfe"sv, "text in UTF-16", "save it as plain text or UTF-8"},
    Kind{0, "\xfe\xff"sv, "text in UTF-16", "save it as plain text or UTF-8"}};

constexpr const char* remedy_dicom =
    "convert it first: a segmentation (SEG) by segimage2itkimage of dcmqi, contours (RTSTRUCT) by plastimatch "
    "or 3D Slicer, an image by dcm2niix and then segment it";

std::string_view dicom_kind(std::string_view bytes) {
  const std::string_view start = bytes.substr(0, 4096);
  if (start.find("1.2.840.10008.5.1.4.1.1.66.4") != std::string_view::npos)
    return "a DICOM segmentation (SEG)";
  if (start.find("1.2.840.10008.5.1.4.1.1.481.3") != std::string_view::npos)
    return "contours in DICOM (RTSTRUCT)";
  return "a DICOM file";
}

// The attribute `type` of the root of a VTK file in XML, empty for other files.
std::string_view vtk_type(std::string_view bytes) {
  constexpr std::string_view element = "<VTKFile", attribute = " type=\"";
  std::string_view text = bytes.substr(0, 4096);
  if (text.find(element) == std::string_view::npos) return {};
  text.remove_prefix(text.find(element));
  text = text.substr(0, text.find('>'));
  if (text.find(attribute) == std::string_view::npos) return {};
  text.remove_prefix(text.find(attribute) + attribute.size());
  return text.substr(0, text.find('"'));
}

}  // namespace

void refuse_foreign(const Source& source) {
  constexpr std::size_t preamble = 128;
  if (source.bytes.size() > preamble && source.bytes.substr(preamble).starts_with("DICM"))
    source.refuse("is " + std::string(dicom_kind(source.bytes)), remedy_dicom);
  for (const Kind& kind : kinds)
    if (source.bytes.size() > kind.at && source.bytes.substr(kind.at).starts_with(kind.mark))
      source.refuse(std::string("is ") + kind.name, kind.remedy);
  if (const std::string_view type = vtk_type(source.bytes); !type.empty() && type != "PolyData")
    source.refuse("is a VTK file of the type " + in_quotes(type),
                  "save its surface as VTP or PLY, in ParaView after the filter Extract Surface");
  const std::string start = lower_case(source.bytes.substr(0, 64));
  if (start.find("<!doctype html") != std::string::npos || start.starts_with("<html"))
    source.refuse("is a web page", "it may be a download that failed or needs a login: download it again");
}

void refuse_foreign(const std::filesystem::path& path) {
  std::string start(4096, '\0');
  std::ifstream in(path, std::ios::binary);
  in.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(in.gcount()));
  refuse_foreign(Source{path.string(), start});
}

}  // namespace foramen::io_detail
