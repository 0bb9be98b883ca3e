#pragma once
// An off-screen OpenGL context of our own. Which kind is chosen when the program is configured:
// OSMesa (Mesa before 25.1) or EGL on the surfaceless platform.

#include <memory>
#include <string>

namespace tribolog::render::vtk {

/// One per process, and only in a worker.
class GlContext {
 public:
  virtual ~GlContext() = default;
  virtual bool make_current() = 0;
  virtual bool is_current() = 0;
  virtual void* function(const char* name) = 0;

  /// "OSMesa" or "EGL".
  [[nodiscard]] virtual std::string back_end() const = 0;
  /// What glGetString says; the context must be current.
  [[nodiscard]] virtual std::string gl_version() const = 0;
  [[nodiscard]] virtual std::string gl_renderer() const = 0;
};

/// Makes the context and makes it current.
/// @throw tribolog::FigureError naming the package to install, or the foreign OpenGL library that
/// stands in the way (an LD_PRELOADed libGL would draw white figures without any error).
std::unique_ptr<GlContext> make_gl_context();

}  // namespace tribolog::render::vtk
