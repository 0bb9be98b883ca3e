#include <array>
#include <string>

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include "base/error.h"
#include "render/vtk/gl_context.h"

namespace tribolog::render::vtk {
namespace {

// Asked for through EGL, so that nothing here needs libGL.
using GetString = const unsigned char* (*)(unsigned int);
constexpr unsigned int gl_renderer_name = 0x1F01;
constexpr unsigned int gl_version_name = 0x1F02;

class EglContext final : public GlContext {
 public:
  EglContext() {
    display_ = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display_ == EGL_NO_DISPLAY || eglInitialize(display_, nullptr, nullptr) == EGL_FALSE) {
      fail({"drawing.egl_without_surfaceless_platform"});
    }
    if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE) fail({"drawing.egl_without_opengl"});
    const std::array<EGLint, 17> wanted{EGL_SURFACE_TYPE,
                                        EGL_PBUFFER_BIT,
                                        EGL_RENDERABLE_TYPE,
                                        EGL_OPENGL_BIT,
                                        EGL_RED_SIZE,
                                        8,
                                        EGL_GREEN_SIZE,
                                        8,
                                        EGL_BLUE_SIZE,
                                        8,
                                        EGL_ALPHA_SIZE,
                                        8,
                                        EGL_DEPTH_SIZE,
                                        24,
                                        EGL_STENCIL_SIZE,
                                        8,
                                        EGL_NONE};
    EGLConfig config{};
    EGLint found = 0;
    if (eglChooseConfig(display_, wanted.data(), &config, 1, &found) == EGL_FALSE || found < 1) {
      fail({"drawing.egl_without_configuration"});
    }
    const std::array<EGLint, 7> core{EGL_CONTEXT_MAJOR_VERSION,
                                     3,
                                     EGL_CONTEXT_MINOR_VERSION,
                                     2,
                                     EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                     EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                     EGL_NONE};
    context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, core.data());
    const std::array<EGLint, 5> small{EGL_WIDTH, 4, EGL_HEIGHT, 4, EGL_NONE};
    surface_ = eglCreatePbufferSurface(display_, config, small.data());
    if (context_ == EGL_NO_CONTEXT || surface_ == EGL_NO_SURFACE || !make_current()) {
      fail({"drawing.egl_without_context"});
    }
    // Asked now: while VTK has another context current, or none, there is no answer.
    gl_version_ = gl_text(gl_version_name);
    gl_renderer_ = gl_text(gl_renderer_name);
  }
  ~EglContext() override { close(); }
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  bool make_current() override {
    return eglMakeCurrent(display_, surface_, surface_, context_) == EGL_TRUE;
  }
  bool is_current() override { return eglGetCurrentContext() == context_; }
  void* function(const char* name) override {
    return reinterpret_cast<void*>(eglGetProcAddress(name));
  }
  [[nodiscard]] std::string back_end() const override { return "EGL"; }
  [[nodiscard]] std::string gl_version() const override { return gl_version_; }
  [[nodiscard]] std::string gl_renderer() const override { return gl_renderer_; }

 private:
  [[noreturn]] void fail(const Statement& what) {
    close();
    throw FigureError({"drawing.install_egl", {{"what", what}}});
  }
  void close() {
    if (display_ == EGL_NO_DISPLAY) return;
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context_ != EGL_NO_CONTEXT) eglDestroyContext(display_, context_);
    if (surface_ != EGL_NO_SURFACE) eglDestroySurface(display_, surface_);
    eglTerminate(display_);
    display_ = EGL_NO_DISPLAY;
  }
  static std::string gl_text(unsigned int name) {
    const auto get_string = reinterpret_cast<GetString>(eglGetProcAddress("glGetString"));
    const unsigned char* text = get_string == nullptr ? nullptr : get_string(name);
    return text == nullptr ? "unknown" : reinterpret_cast<const char*>(text);
  }

  EGLDisplay display_{EGL_NO_DISPLAY};
  EGLContext context_{EGL_NO_CONTEXT};
  EGLSurface surface_{EGL_NO_SURFACE};
  std::string gl_version_;
  std::string gl_renderer_;
};

}  // namespace

std::unique_ptr<GlContext> make_gl_context() { return std::make_unique<EglContext>(); }

}  // namespace tribolog::render::vtk
