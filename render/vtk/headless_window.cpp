#include "render/vtk/headless_window.h"

#include <vtkObjectFactory.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkVersion.h>
#include <vtkVersionMacros.h>

#include "base/error.h"

// VTK up to 9.3 finds OpenGL functions with GLEW, later ones with a loader that may be set.
#if VTK_MAJOR_VERSION < 9 || (VTK_MAJOR_VERSION == 9 && VTK_MINOR_VERSION < 4)
#define TRIBOLOG_VTK_HAS_GLEW 1
#else
#define TRIBOLOG_VTK_HAS_GLEW 0
#endif

#if TRIBOLOG_VTK_HAS_GLEW
#include <vtk_glew.h>
#endif

namespace tribolog::render::vtk {

vtkStandardNewMacro(HeadlessWindow);

HeadlessWindow::HeadlessWindow() {
  SetMapped(true);
  SetIsCurrent(true);
  SetReadyForRendering(true);
  SetSupportsOpenGL(1);
  SetIsDirect(0);
  SetDPI(72);  // a point of type is a pixel
}

HeadlessWindow::~HeadlessWindow() {
  Finalize();
  context_ = nullptr;
}

void HeadlessWindow::attach(GlContext* context) {
  context_ = context;
#if !TRIBOLOG_VTK_HAS_GLEW
  SetOpenGLSymbolLoader(
      [](void* from, const char* name) {
        return reinterpret_cast<VTKOpenGLAPIProc>(static_cast<GlContext*>(from)->function(name));
      },
      context);
#endif
}

void HeadlessWindow::MakeCurrent() {
  if (context_ != nullptr && !context_->is_current()) context_->make_current();
}

bool HeadlessWindow::IsCurrent() { return context_ != nullptr && context_->is_current(); }

void HeadlessWindow::Start() {
  Superclass::Start();
  if (!needs_depth_) {
    RenderFramebuffer->RemoveDepthAttachment();
  } else if (!has_depth_) {
    // Adding only depth would give it one sample a pixel and leave the buffer incomplete.
    constexpr int depth_bits = 24;
    RenderFramebuffer->PopulateFramebuffer(Size[0], Size[1], true, 1, VTK_UNSIGNED_CHAR, true,
                                           depth_bits, MultiSamples);
    RenderFramebuffer->Bind();
    RenderFramebuffer->ActivateBuffer(0);
  }
  has_depth_ = needs_depth_;
}

void HeadlessWindow::OpenGLInitContext() {
#if TRIBOLOG_VTK_HAS_GLEW
  ContextCreationTime.Modified();
  if (Initialized) return;
  MakeCurrent();
  glewExperimental = GL_TRUE;
  const GLenum result = glewInit();
  constexpr GLenum no_glx = 3;          // GLEW_ERROR_GLX_VERSION_11_ONLY
  constexpr GLenum no_glx_display = 4;  // GLEW_ERROR_NO_GLX_DISPLAY
  const bool tolerable = result == GLEW_OK || result == no_glx || result == no_glx_display;
  const bool complete =
      GLEW_VERSION_3_2 && glGenVertexArrays != nullptr && glBindFramebuffer != nullptr;
  if (!tolerable || !complete) {
    throw FigureError({"drawing.no_opengl_functions", {{"status", result}}});
  }
  GlewInitValid = true;
  Initialized = true;
  MaximumHardwareLineWidth = 1;  // lines are drawn as areas
#else
  Superclass::OpenGLInitContext();
#endif
}

}  // namespace tribolog::render::vtk
