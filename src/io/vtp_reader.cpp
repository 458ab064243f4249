#include "io/mesh_formats.hpp"

#ifdef FORAMEN_WITH_VTK
#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>

#include <array>
#include <string>
#endif

namespace foramen::io_detail {

#ifdef FORAMEN_WITH_VTK
namespace {

constexpr const char* remedy_damaged =
    "the file is damaged, cut off or no VTK surface: export it again, best as PLY";

// Keeps what VTK would print, and hands it to our own error.
class VtkErrors {
 public:
  VtkErrors() {
    command_->SetClientData(this);
    command_->SetCallback([](vtkObject*, unsigned long, void* self, void* text) {
      auto& errors = *static_cast<VtkErrors*>(self);
      if (errors.first_.empty()) errors.first_ = text ? static_cast<const char*>(text) : "no reason given";
    });
  }
  vtkCommand* command() { return command_; }
  void watch(vtkObject& object) {
    object.AddObserver(vtkCommand::ErrorEvent, command_);
    object.AddObserver(vtkCommand::WarningEvent, command_);
  }
  void refuse_if_any(const Source& source) const {
    if (first_.empty()) return;
    // "ERROR: In file.cxx, line 7\nvtkClass (0x...): the reason\n\n": only the reason is the user's business.
    const auto at = first_.find("): ");
    std::string reason = at == std::string::npos ? first_ : first_.substr(at + 3);
    for (char& c : reason)
      if (c < ' ' || c > '~') c = ' ';
    reason.erase(reason.find_last_not_of(' ') + 1);
    source.refuse("VTK cannot read it (" + reason + ")", remedy_damaged);
  }

 private:
  vtkNew<vtkCallbackCommand> command_;
  std::string first_;
};

// A count in the file must not make VTK allocate more than the file could hold.
void check_counts(const Source& source, std::string_view attribute) {
  // Deflate packs at most about 1032 bytes into one.
  constexpr std::uint64_t densest = 1032;
  constexpr std::size_t longest = 24;
  const std::string key = std::string(attribute) + "=\"";
  for (auto at = source.bytes.find(key); at != std::string_view::npos; at = source.bytes.find(key, at + 1)) {
    const std::string_view value = source.bytes.substr(at + key.size(), longest);
    const std::string_view written = value.substr(0, value.find('"'));
    const auto count = to_integer(written);
    if (!count || *count < 0 || static_cast<std::uint64_t>(*count) > densest * source.bytes.size())
      source.refuse("announces " + in_quotes(written) + " as " + std::string(attribute) + ", but has " +
                        std::to_string(source.bytes.size()) + " bytes",
                    remedy_damaged);
  }
}

void check_header(const Source& source) {
  const auto root = source.bytes.find("<VTKFile");
  if (root == std::string_view::npos)
    source.refuse("has no <VTKFile> element", "it is no VTK XML file: check its format and extension");
  if (source.bytes.find("type=\"PolyData\"", root) == std::string_view::npos)
    source.refuse("is no PolyData", "foramen reads surfaces, no images or grids: export the surface");
  const auto last = source.bytes.find_last_not_of(" \t\r\n");
  if (!source.bytes.substr(0, last + 1).ends_with("</VTKFile>"))
    source.refuse("does not end with </VTKFile>", remedy_damaged);
  for (const std::string_view attribute :
       {"NumberOfPoints", "NumberOfPolys", "NumberOfStrips", "NumberOfLines", "NumberOfVerts",
        "NumberOfTuples", "NumberOfComponents"})
    check_counts(source, attribute);
}

TriangleSoup soup_of(const Source& source, vtkPolyData& data) {
  SoupBuilder soup(source);
  const auto points = static_cast<std::uint64_t>(data.GetNumberOfPoints());
  if (data.GetNumberOfStrips() > 0) source.refuse("holds triangle strips", remedy_triangulate);
  if (data.GetNumberOfVerts() + data.GetNumberOfLines() > 0)
    source.refuse("holds loose points or lines beside faces", "remove them, or export the surface alone");
  soup.expect(points, static_cast<std::uint64_t>(data.GetNumberOfPolys()), source.bytes.size(), 0, 0);
  for (std::uint64_t v = 0; v < points; ++v) {
    std::array<double, 3> p{};
    data.GetPoint(static_cast<vtkIdType>(v), p.data());
    soup.add_point({p[0], p[1], p[2]}, [&] { return "vertex " + std::to_string(v); });
  }
  vtkNew<vtkIdList> corners;
  for (vtkIdType f = 0; f < data.GetNumberOfPolys(); ++f) {
    const auto place = [&] { return "face " + std::to_string(f); };
    data.GetPolys()->GetCellAtId(f, corners);
    if (corners->GetNumberOfIds() != 3)
      refuse_polygon(source, place(), static_cast<std::uint64_t>(corners->GetNumberOfIds()));
    soup.add_triangle({corners->GetId(0), corners->GetId(1), corners->GetId(2)}, points, place);
  }
  return soup.take();
}

}  // namespace

MeshFile read_vtp(const std::filesystem::path& path) {
  const std::string bytes = read_bytes(path);
  const Source source{path.string(), bytes};
  check_header(source);
  VtkErrors errors;
  vtkNew<vtkXMLPolyDataReader> reader;
  errors.watch(*reader);
  errors.watch(*reader->GetExecutive());
  reader->SetReaderErrorObserver(errors.command());
  reader->SetParserErrorObserver(errors.command());
  reader->SetFileName(path.c_str());
  reader->Update();
  errors.refuse_if_any(source);
  vtkPolyData& data = *reader->GetOutput();
  SpaceTag space;
  auto* tag = vtkStringArray::SafeDownCast(data.GetFieldData()->GetAbstractArray("SPACE"));
  if (tag && tag->GetNumberOfValues() > 0) space.see(source, "SPACE=" + tag->GetValue(0));
  return {soup_of(source, data), space.value()};
}

#else

MeshFile read_vtp(const std::filesystem::path& path) {
  Source{path.string(), {}}.refuse(
      "this build of foramen reads no VTP files (VTK was not found when it was built)",
      "convert it to PLY, or install VTK 9 and build foramen again");
}

#endif

}  // namespace foramen::io_detail
