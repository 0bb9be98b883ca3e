#pragma once
// VTK's render window on a context of ours, and VTK's own threads.

#include <vtkGenericOpenGLRenderWindow.h>

#include "render/vtk/gl_context.h"

namespace tribolog::render::vtk {

class HeadlessWindow : public vtkGenericOpenGLRenderWindow {
 public:
  static HeadlessWindow* New();
  vtkTypeMacro(HeadlessWindow, vtkGenericOpenGLRenderWindow)

      /// The context must outlive the window. To be called before anything is drawn.
      void attach(GlContext* context);

  void MakeCurrent() override;
  bool IsCurrent() override;
  int SupportsOpenGL() override { return 1; }
  void OpenGLInitContext() override;
  void DestroyWindow() override {}
  /// Whether what is drawn next needs the depth buffer that VTK adds. Flat drawings need none, and
  /// clearing its samples takes a tenth of the time.
  void keep_depth(bool needed) { needs_depth_ = needed; }
  void Start() override;

  HeadlessWindow(const HeadlessWindow&) = delete;
  HeadlessWindow& operator=(const HeadlessWindow&) = delete;

 protected:
  HeadlessWindow();
  ~HeadlessWindow() override;

 private:
  GlContext* context_{};
  bool needs_depth_{false};
  bool has_depth_{true};
};

/// VTK computes in the caller's thread from now on. A process with more threads than one cannot be
/// forked safely, and here processes share the work.
void keep_vtk_to_one_thread();

}  // namespace tribolog::render::vtk
