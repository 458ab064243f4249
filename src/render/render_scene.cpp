#include "foramen/render/render_scene.hpp"

#include <cstdlib>

#include "foramen/core/error.hpp"

#ifdef FORAMEN_WITH_VTK
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
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
#include <vtkTubeFilter.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <vtkAutoInit.h>
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

vtkNew<vtkUnsignedCharArray> colour_array(const std::vector<Colour>& colours) {
  vtkNew<vtkUnsignedCharArray> array;
  array->SetNumberOfComponents(3);
  for (const Colour& c : colours) array->InsertNextTypedTuple(c.data());
  return array;
}

void paint(vtkActor& actor, const Colour& c) {
  actor.GetProperty()->SetColor(c[0] / 255.0, c[1] / 255.0, c[2] / 255.0);
}

vtkNew<vtkActor> surface_actor(const SceneSurface& surface) {
  vtkNew<vtkPoints> points;
  for (const Vec3& p : surface.soup.points) points->InsertNextPoint(p.data());
  vtkNew<vtkCellArray> cells;
  for (const auto& t : surface.soup.triangles) cells->InsertNextCell({t[0], t[1], t[2]});
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(cells);
  if (!surface.vertex_colours.empty()) data->GetPointData()->SetScalars(colour_array(surface.vertex_colours));
  if (!surface.face_colours.empty()) data->GetCellData()->SetScalars(colour_array(surface.face_colours));

  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkPolyDataNormals> normals;
  const bool flat = !surface.face_colours.empty() || surface.edges || !surface.lit;
  if (flat) {
    mapper->SetInputData(data);
  } else {
    normals->SetInputData(data);
    normals->SplittingOff();
    normals->ConsistencyOff();
    mapper->SetInputConnection(normals->GetOutputPort());
  }
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  paint(*actor, surface.colour);
  actor->GetProperty()->SetInterpolation(flat ? VTK_FLAT : VTK_PHONG);
  actor->GetProperty()->SetLighting(surface.lit);
  actor->GetProperty()->SetEdgeVisibility(surface.edges);
  actor->GetProperty()->SetEdgeColor(0.25, 0.25, 0.25);
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

void set_camera(vtkRenderer& renderer, const Scene& scene) {
  vtkCamera& camera = *renderer.GetActiveCamera();
  camera.ParallelProjectionOn();
  const Vec3 direction = scene.direction.normalized();
  camera.SetFocalPoint(0, 0, 0);
  camera.SetPosition(-direction.x(), -direction.y(), -direction.z());
  camera.SetViewUp(scene.up.x(), scene.up.y(), scene.up.z());
  renderer.ResetCamera();
  camera.SetParallelScale(scene.height_mm > 0 ? scene.height_mm / 2 : camera.GetParallelScale() * 0.78);
  renderer.ResetCameraClippingRange();
}

}  // namespace

std::string render_png(const std::vector<Scene>& scenes, int columns, const PictureSize& size) {
  if (!can_render())
    throw Error("pictures need a display and there is none (DISPLAY is not set): run under xvfb-run -a");
  FORAMEN_ASSERT(!scenes.empty() && columns > 0);
  const int count = static_cast<int>(scenes.size()), rows = (count + columns - 1) / columns;
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(8);
  window->SetSize(size.width * columns, size.height * rows);
  for (int i = 0; i < count; ++i) {
    const Scene& scene = scenes[static_cast<std::size_t>(i)];
    vtkNew<vtkRenderer> renderer;
    const int column = i % columns, row = rows - 1 - i / columns;
    renderer->SetViewport(double(column) / columns, double(row) / rows, double(column + 1) / columns,
                          double(row + 1) / rows);
    renderer->SetBackground(1, 1, 1);
    for (const SceneSurface& surface : scene.surfaces) renderer->AddActor(surface_actor(surface));
    for (const SceneCurve& curve : scene.curves) renderer->AddActor(curve_actor(curve));
    window->AddRenderer(renderer);
    set_camera(*renderer, scene);
  }
  window->Render();
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->WriteToMemoryOn();
  writer->SetInputConnection(grab->GetOutputPort());
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  return {reinterpret_cast<const char*>(bytes->GetPointer(0)),
          static_cast<std::size_t>(bytes->GetNumberOfValues())};
}
#else
std::string render_png(const std::vector<Scene>&, int, const PictureSize&) {
  throw Error("this build of foramen has no VTK and makes no pictures: install libvtk9-dev and build again");
}
#endif

}  // namespace foramen
