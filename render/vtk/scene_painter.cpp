#include "render/vtk/scene_painter.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkLight.h>
#include <vtkMatrix4x4.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include "render/figure/scene.h"

namespace tribolog::render::vtk {
namespace {

constexpr double ambient = 0.46;
constexpr double key_light = 0.50;   // from above and the left, in front of the scene
constexpr double fill_light = 0.20;  // from the eye
constexpr figure::Colour outline_colour{45, 45, 45};

/// Collects meshes as one set of triangles.
class TriangleSet {
 public:
  TriangleSet() {
    normals_->SetNumberOfComponents(3);
    colours_->SetNumberOfComponents(3);
  }

  void add(const figure::SceneMesh& mesh, figure::Colour colour, double outwards_px,
           const figure::SceneView& view) {
    const vtkIdType first = points_->GetNumberOfPoints();
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
      figure::Point3 p = mesh.points[i];
      if (outwards_px > 0) p = p + (outwards_px * view.metres_per_pixel(p)) * mesh.spread[i];
      const figure::Point3& n = mesh.normals[i];
      points_->InsertNextPoint(p.x, p.y, p.z);
      normals_->InsertNextTuple3(n.x, n.y, n.z);
      colours_->InsertNextTuple3(colour.red, colour.green, colour.blue);
    }
    for (const auto& [a, b, c] : mesh.triangles) {
      const vtkIdType corners[] = {first + a, first + b, first + c};
      triangles_->InsertNextCell(3, corners);
    }
  }

  void show(vtkActor* actor, vtkRenderer* renderer) {
    if (triangles_->GetNumberOfCells() == 0) return;
    vtkNew<vtkPolyData> data;
    data->SetPoints(points_);
    data->SetPolys(triangles_);
    data->GetPointData()->SetNormals(normals_);
    data->GetPointData()->SetScalars(colours_);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    mapper->SetScalarModeToUsePointData();
    mapper->SetColorModeToDirectScalars();
    actor->SetMapper(mapper);
    renderer->AddActor(actor);
  }

 private:
  vtkNew<vtkPoints> points_;
  vtkNew<vtkFloatArray> normals_;
  vtkNew<vtkUnsignedCharArray> colours_;
  vtkNew<vtkCellArray> triangles_;
};

void add_light(vtkRenderer* renderer, double x, double y, double z, double intensity) {
  vtkNew<vtkLight> light;
  light->SetLightTypeToCameraLight();
  light->SetPosition(x, y, z);
  light->SetFocalPoint(0, 0, 0);
  light->SetIntensity(intensity);
  renderer->AddLight(light);
}

}  // namespace

ScenePainter::ScenePainter(vtkRenderer* renderer, const figure::SceneGeometry& scene,
                           double outline_px)
    : renderer_(renderer), view_(scene.view) {
  add_flat_areas(scene);
  add_outlines(scene, outline_px);
  add_surfaces(scene);
  add_lights();
  const figure::Point3 target = view_.eye + view_.farthest_m * view_.forward;
  camera_->SetPosition(view_.eye.x, view_.eye.y, view_.eye.z);
  camera_->SetFocalPoint(target.x, target.y, target.z);
  camera_->SetViewUp(view_.up.x, view_.up.y, view_.up.z);
  camera_->SetParallelProjection(view_.parallel ? 1 : 0);
  camera_->SetUseExplicitProjectionTransformMatrix(true);
  renderer_->SetActiveCamera(camera_);
}

ScenePainter::~ScenePainter() {
  for (vtkActor* actor : {surfaces_.Get(), flat_areas_.Get(), outlines_.Get()}) {
    renderer_->RemoveActor(actor);
    actor->ReleaseGraphicsResources(renderer_->GetVTKWindow());
  }
  renderer_->RemoveAllLights();
  renderer_->SetActiveCamera(nullptr);
}

void ScenePainter::show_rows(int width, int top, int rows) {
  const auto elements = view_.clip_matrix(width, top, rows);
  vtkNew<vtkMatrix4x4> matrix;
  matrix->DeepCopy(elements.data());
  camera_->SetExplicitProjectionTransformMatrix(matrix);
  camera_->Modified();
}

void ScenePainter::add_surfaces(const figure::SceneGeometry& scene) {
  TriangleSet set;
  for (const figure::SceneMesh& mesh : scene.meshes) {
    if (mesh.finish == figure::SceneMesh::Finish::lit) set.add(mesh, mesh.colour, 0, view_);
  }
  set.show(surfaces_, renderer_);
  vtkProperty* look = surfaces_->GetProperty();
  look->SetInterpolationToGouraud();
  look->SetAmbient(ambient);
  look->SetDiffuse(1.0);
  look->SetSpecular(0.0);
  look->BackfaceCullingOn();
}

void ScenePainter::add_flat_areas(const figure::SceneGeometry& scene) {
  TriangleSet set;
  for (const figure::SceneMesh& mesh : scene.meshes) {
    if (mesh.finish == figure::SceneMesh::Finish::flat) set.add(mesh, mesh.colour, 0, view_);
  }
  set.show(flat_areas_, renderer_);
  flat_areas_->GetProperty()->LightingOff();
}

/// What can be seen of the far side of a slightly larger part is its outline.
void ScenePainter::add_outlines(const figure::SceneGeometry& scene, double outline_px) {
  TriangleSet set;
  for (const figure::SceneMesh& mesh : scene.meshes) {
    if (mesh.finish == figure::SceneMesh::Finish::lit)
      set.add(mesh, outline_colour, outline_px, view_);
  }
  set.show(outlines_, renderer_);
  outlines_->GetProperty()->LightingOff();
  outlines_->GetProperty()->FrontfaceCullingOn();
}

void ScenePainter::add_lights() {
  renderer_->RemoveAllLights();  // VTK adds one of its own to whatever was drawn before
  add_light(renderer_, -0.6, 1.0, 0.8, key_light);
  add_light(renderer_, 0.0, 0.0, 1.0, fill_light);
}

}  // namespace tribolog::render::vtk
