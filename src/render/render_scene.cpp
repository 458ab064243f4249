#include "render/render_scene.hpp"

#include <cmath>
#include <cstdlib>

#include "foramen/core/error.hpp"

#ifdef FORAMEN_WITH_VTK
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkLightKit.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkPolyLine.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkTubeFilter.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <vtkAutoInit.h>
VTK_MODULE_INIT(vtkRenderingFreeType)
VTK_MODULE_INIT(vtkRenderingOpenGL2)
#endif

namespace foramen {

bool can_render() {
#ifdef FORAMEN_WITH_VTK
  const char* display = std::getenv("DISPLAY");
  return display != nullptr && display[0] != '\0';
#else
  return false;
#endif
}

#ifdef FORAMEN_WITH_VTK
namespace {

// The camera is in front of all objects. With parallel projection, its distance does not change the picture.
constexpr double camera_distance_mm = 1000;
constexpr int supersampling = 3;
constexpr double key_light = 0.85, key_to_fill = 2.0;
constexpr double ambient = 0.1;
constexpr float edge_width = 0.6F;     // pixels of the picture
constexpr double wire_opacity = 0.25;  // each edge is drawn twice, once for each of its triangles

vtkNew<vtkUnsignedCharArray> colour_array(const std::vector<Colour>& colours) {
  vtkNew<vtkUnsignedCharArray> array;
  array->SetNumberOfComponents(3);
  for (const Colour& c : colours) array->InsertNextTypedTuple(c.data());
  return array;
}

void paint(vtkActor& actor, const Colour& c) {
  actor.GetProperty()->SetColor(c[0] / 255.0, c[1] / 255.0, c[2] / 255.0);
}

vtkNew<vtkPolyData> poly_data(const SceneSurface& surface) {
  vtkNew<vtkPoints> points;
  for (const Vec3& p : surface.soup.points) points->InsertNextPoint(p.data());
  vtkNew<vtkCellArray> cells;
  for (const auto& t : surface.soup.triangles) cells->InsertNextCell({t[0], t[1], t[2]});
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(cells);
  if (!surface.vertex_colours.empty()) data->GetPointData()->SetScalars(colour_array(surface.vertex_colours));
  if (!surface.face_colours.empty()) data->GetCellData()->SetScalars(colour_array(surface.face_colours));
  if (!surface.vertex_normals.empty()) {
    vtkNew<vtkDoubleArray> normals;
    normals->SetNumberOfComponents(3);
    for (const Vec3& n : surface.vertex_normals) normals->InsertNextTypedTuple(n.data());
    data->GetPointData()->SetNormals(normals);
  }
  return data;
}

vtkNew<vtkActor> surface_actor(const SceneSurface& surface) {
  const vtkNew<vtkPolyData> data = poly_data(surface);
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkPolyDataNormals> normals;
  const bool smooth = surface.style == SurfaceStyle::smooth;
  const bool lit =
      smooth || surface.style == SurfaceStyle::facets || surface.style == SurfaceStyle::triangles;
  if (smooth && surface.vertex_normals.empty()) {
    normals->SetInputData(data);
    normals->SplittingOff();
    normals->ConsistencyOff();
    mapper->SetInputConnection(normals->GetOutputPort());
  } else {
    mapper->SetInputData(data);
  }
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkProperty& property = *actor->GetProperty();
  paint(*actor, surface.colour);
  property.SetAmbient(ambient);
  property.SetInterpolation(smooth ? VTK_PHONG : VTK_FLAT);
  property.SetLighting(lit);
  property.SetEdgeVisibility(surface.style == SurfaceStyle::triangles);
  property.SetEdgeColor(0.35, 0.33, 0.30);
  property.SetLineWidth(supersampling * edge_width);
  if (surface.style == SurfaceStyle::wires) {
    property.SetRepresentationToWireframe();
    property.SetColor(0, 0, 0);
    property.SetOpacity(wire_opacity);
  }
  return actor;
}

vtkNew<vtkActor> curve_actor(const SceneCurve& curve) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkPolyLine> polyline;
  const std::size_t count = curve.points.size() + (curve.closed ? 1 : 0);
  for (std::size_t i = 0; i < count; ++i) {
    points->InsertNextPoint(curve.points[i % curve.points.size()].data());
    polyline->GetPointIds()->InsertNextId(static_cast<vtkIdType>(i));
  }
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(polyline);
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(cells);
  vtkNew<vtkTubeFilter> tube;
  tube->SetInputData(data);
  tube->SetRadius(curve.radius);
  tube->SetNumberOfSides(12);
  tube->CappingOn();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(tube->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  paint(*actor, curve.colour);
  return actor;
}

// \param pixels_per_mm  resolution of the picture before it is reduced
vtkNew<vtkTextActor> text_actor(const SceneText& text, double pixels_per_mm) {
  vtkNew<vtkTextActor> actor;
  actor->SetInput(text.text.c_str());
  actor->GetPositionCoordinate()->SetCoordinateSystemToWorld();
  actor->GetPositionCoordinate()->SetValue(text.at.x(), text.at.y(), text.at.z());
  vtkTextProperty& property = *actor->GetTextProperty();
  property.SetFontFamilyToArial();
  property.SetFontSize(static_cast<int>(std::lround(text.height_mm * pixels_per_mm)));
  property.SetColor(0, 0, 0);
  property.SetVerticalJustificationToCentered();
  return actor;
}

void set_camera(vtkRenderer& renderer, const Camera& scene) {
  vtkCamera& camera = *renderer.GetActiveCamera();
  camera.ParallelProjectionOn();
  const Vec3 position = scene.centre - camera_distance_mm * scene.direction.normalized();
  camera.SetFocalPoint(scene.centre.data());
  camera.SetPosition(position.data());
  camera.SetViewUp(scene.up.data());
  camera.SetParallelScale(scene.height_mm / 2);
  renderer.ResetCameraClippingRange();
}

// When its last client leaves, an X server restarts and refuses connections meanwhile, and VTK then aborts.
// Therefore one window stays open, so that the server always has a client. The window is never destroyed,
// because VTK's own objects may already be destroyed at that time.
void keep_connected() {
  [[maybe_unused]] static vtkRenderWindow* const kept = [] {
    vtkRenderWindow* window = vtkRenderWindow::New();
    window->SetOffScreenRendering(1);
    window->SetSize(1, 1);
    window->Render();
    return window;
  }();
}

// Pixels of a picture, counted from its top left corner.
struct Panel {
  const Scene* scene;
  double left, top, width, height;
};

std::vector<Panel> arranged(const std::vector<std::vector<Scene>>& rows, double width) {
  std::vector<Panel> panels;
  double top = 0;
  for (const auto& row : rows) {
    double shapes = 0;
    for (const Scene& scene : row) shapes += scene.camera.width_mm / scene.camera.height_mm;
    const double height = width / shapes;
    double left = 0;
    for (const Scene& scene : row) {
      panels.push_back({&scene, left, top, height * scene.camera.width_mm / scene.camera.height_mm, height});
      left += panels.back().width;
    }
    top += height;
  }
  return panels;
}

// Each pixel of the result is the mean of a square of pixels, so details finer than a pixel become shades.
vtkNew<vtkImageData> shrunk(vtkImageData& image) {
  const int* fine = image.GetDimensions();
  const int width = fine[0] / supersampling, height = fine[1] / supersampling;
  vtkNew<vtkImageData> out;
  out->SetDimensions(width, height, 1);
  out->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  const auto* from = static_cast<const unsigned char*>(image.GetScalarPointer());
  auto* to = static_cast<unsigned char*>(out->GetScalarPointer());
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int channel = 0; channel < 3; ++channel) {
        int sum = 0;
        for (int j = 0; j < supersampling; ++j)
          for (int i = 0; i < supersampling; ++i)
            sum += from[3 * ((supersampling * y + j) * fine[0] + supersampling * x + i) + channel];
        constexpr int count = supersampling * supersampling;
        *to++ = static_cast<unsigned char>((sum + count / 2) / count);
      }
  return out;
}

}  // namespace

std::string render_png(const std::vector<std::vector<Scene>>& rows, int width_pixels) {
  if (!can_render())
    throw Error("pictures need a display and there is none (DISPLAY is not set): run under xvfb-run -a");
  const std::vector<Panel> panels = arranged(rows, width_pixels);
  FORAMEN_ASSERT(!panels.empty());
  const double height = panels.back().top + panels.back().height;
  keep_connected();
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(supersampling * width_pixels, supersampling * static_cast<int>(std::lround(height)));
  for (const Panel& panel : panels) {
    vtkNew<vtkRenderer> renderer;
    renderer->SetViewport(panel.left / width_pixels, 1 - (panel.top + panel.height) / height,
                          (panel.left + panel.width) / width_pixels, 1 - panel.top / height);
    renderer->SetBackground(1, 1, 1);
    for (const SceneSurface& surface : panel.scene->surfaces) renderer->AddActor(surface_actor(surface));
    for (const SceneCurve& curve : panel.scene->curves) renderer->AddActor(curve_actor(curve));
    const double pixels_per_mm = supersampling * panel.height / panel.scene->camera.height_mm;
    for (const SceneText& text : panel.scene->texts) renderer->AddActor2D(text_actor(text, pixels_per_mm));
    vtkNew<vtkLightKit> lights;
    lights->SetKeyLightIntensity(key_light);
    lights->SetKeyToFillRatio(key_to_fill);
    lights->AddLightsToRenderer(renderer);
    window->AddRenderer(renderer);
    set_camera(*renderer, panel.scene->camera);
  }
  window->Render();
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->WriteToMemoryOn();
  writer->SetCompressionLevel(9);
  grab->Update();
  writer->SetInputData(shrunk(*grab->GetOutput()));
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  return {reinterpret_cast<const char*>(bytes->GetPointer(0)),
          static_cast<std::size_t>(bytes->GetNumberOfValues())};
}
#else
std::string render_png(const std::vector<std::vector<Scene>>&, int) {
  throw Error("this build of foramen has no VTK and makes no pictures: install libvtk9-dev and build again");
}
#endif

}  // namespace foramen
