#pragma once
// The solid parts of a scene in VTK: surfaces in soft light, each with a dark outline.

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>

#include "render/figure/draw_list.h"

namespace tribolog::render::vtk {

/// Puts a scene into a renderer and takes it away again when it ends.
class ScenePainter {
 public:
  /// Both must live as long as this. @param outline_px width of the outlines in pixels
  ScenePainter(vtkRenderer* renderer, const figure::SceneGeometry& scene, double outline_px);
  ~ScenePainter();
  ScenePainter(const ScenePainter&) = delete;
  ScenePainter& operator=(const ScenePainter&) = delete;

  /// Points the camera at the part of a picture `width` pixels wide from row `top` on.
  void show_rows(int width, int top, int rows);

 private:
  void add_surfaces(const figure::SceneGeometry& scene);
  void add_flat_areas(const figure::SceneGeometry& scene);
  void add_outlines(const figure::SceneGeometry& scene, double outline_px);
  void add_lights();

  vtkRenderer* renderer_;
  const figure::SceneView& view_;
  vtkNew<vtkCamera> camera_;
  vtkNew<vtkActor> surfaces_;
  vtkNew<vtkActor> flat_areas_;
  vtkNew<vtkActor> outlines_;
};

}  // namespace tribolog::render::vtk
