#pragma once
// Draws draw lists into pictures. One per process; costs a tenth of a second to make. The one that
// does it with VTK lies in a module, which is loaded when a painter is made.

#include <memory>

#include "render/figure/draw_list.h"
#include "render/figure/picture.h"
#include "render/text/font.h"

namespace tribolog::render::paint {

class Painter {
 public:
  Painter() = default;
  virtual ~Painter() = default;
  Painter(const Painter&) = delete;
  Painter& operator=(const Painter&) = delete;

  /// The same list gives the same bytes, whatever was painted before.
  /// @param strip_rows how much of a scene is painted at once, which bounds memory: the
  /// multisampled buffers of a whole picture would take a few hundred megabytes, and clearing their
  /// pages a quarter of the time. Of a chart, which has one sample a pixel, four times as much.
  /// @throw tribolog::FigureError if VTK reports an error.
  virtual figure::Picture paint(const figure::DrawList& list, int strip_rows) = 0;
  figure::Picture paint(const figure::DrawList& list) { return paint(list, usual_strip_rows); }

  static constexpr int usual_strip_rows = 512;

  [[nodiscard]] virtual figure::RendererInfo info() const = 0;
};

/// VTK's own threads. A process with more threads than one cannot be forked safely.
enum class PainterThreads { as_many_as_it_likes, one };

/// @param font lives as long as the painter.
/// @throw tribolog::FigureError if a library is missing or no context can be made: the package to
/// install.
std::unique_ptr<Painter> make_painter(const text::Font& font,
                                      PainterThreads threads = PainterThreads::as_many_as_it_likes);

}  // namespace tribolog::render::paint

// What the module tribolog_vtk gives to the program.

/// The caller owns it. @throw tribolog::FigureError if no context can be made.
extern "C" __attribute__((visibility("default"))) tribolog::render::paint::Painter*
tribolog_vtk_painter(const tribolog::render::text::Font& font,
                     tribolog::render::paint::PainterThreads threads);
