#include <array>
#include <string>

#include <GL/osmesa.h>
#include <dlfcn.h>

#include "base/error.h"
#include "render/vtk/gl_context.h"

namespace tribolog::render::vtk {
namespace {

std::string gl_text(GLenum name) {
  const auto* text = reinterpret_cast<const char*>(glGetString(name));
  return text == nullptr ? "unknown" : text;
}

/// Every OpenGL call of this process must end up in OSMesa's own library.
void check_no_other_opengl() {
  for (const char* name : {"glClear", "glGetString", "glDrawArrays", "glViewport"}) {
    Dl_info where{};
    void* function = dlsym(RTLD_DEFAULT, name);
    if (function == nullptr || dladdr(function, &where) == 0) {
      throw FigureError({"drawing.opengl_function_missing", {{"function", name}}});
    }
    const std::string library = where.dli_fname;
    if (library.find("libOSMesa") == std::string::npos) {
      throw FigureError({"drawing.foreign_opengl", {{"library", library}}});
    }
  }
}

class OsmesaContext final : public GlContext {
 public:
  OsmesaContext() {
    check_no_other_opengl();
    if (function("glClear") == nullptr) throw FigureError({"drawing.osmesa_without_functions"});
    const std::array<int, 15> wanted{OSMESA_FORMAT,
                                     OSMESA_RGBA,
                                     OSMESA_DEPTH_BITS,
                                     24,
                                     OSMESA_STENCIL_BITS,
                                     8,
                                     OSMESA_PROFILE,
                                     OSMESA_CORE_PROFILE,
                                     OSMESA_CONTEXT_MAJOR_VERSION,
                                     3,
                                     OSMESA_CONTEXT_MINOR_VERSION,
                                     2,
                                     0,
                                     0,
                                     0};
    context_ = OSMesaCreateContextAttribs(wanted.data(), nullptr);
    if (context_ == nullptr || !make_current()) {
      throw FigureError({"drawing.osmesa_without_context"});
    }
  }
  ~OsmesaContext() override {
    if (context_ != nullptr) OSMesaDestroyContext(context_);
  }
  OsmesaContext(const OsmesaContext&) = delete;
  OsmesaContext& operator=(const OsmesaContext&) = delete;

  bool make_current() override {
    return OSMesaMakeCurrent(context_, pixels_.data(), GL_UNSIGNED_BYTE, side, side) != 0;
  }
  bool is_current() override { return OSMesaGetCurrentContext() == context_; }
  void* function(const char* name) override {
    return reinterpret_cast<void*>(OSMesaGetProcAddress(name));
  }
  [[nodiscard]] std::string back_end() const override { return "OSMesa"; }
  [[nodiscard]] std::string gl_version() const override { return gl_text(GL_VERSION); }
  [[nodiscard]] std::string gl_renderer() const override { return gl_text(GL_RENDERER); }

 private:
  static constexpr int side = 4;  // figures are drawn into framebuffers of VTK's own
  OSMesaContext context_{};
  std::array<unsigned char, 4UL * side * side> pixels_{};
};

}  // namespace

std::unique_ptr<GlContext> make_gl_context() { return std::make_unique<OsmesaContext>(); }

}  // namespace tribolog::render::vtk
