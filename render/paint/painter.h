#pragma once
// Draws draw lists with VTK into pictures. One per process; costs a tenth of a second to make.

#include <memory>
#include <string>
#include <vector>

#include "render/draw_list.h"
#include "render/paint/picture.h"
#include "render/renderer.h"
#include "render/text/font.h"

namespace tribolog::render {

class Painter {
 public:
  /// @throw tribolog::FigureError if no context can be made.
  explicit Painter(const Font& font);
  ~Painter();
  Painter(const Painter&) = delete;
  Painter& operator=(const Painter&) = delete;

  /// The same list gives the same bytes, whatever was painted before.
  /// @param strip_rows how much is painted at once, which bounds memory: the multisampled buffers
  /// of a whole picture would take a few hundred megabytes, and clearing their pages a quarter of
  /// the time
  /// @throw tribolog::FigureError if VTK reports an error.
  Picture paint(const DrawList& list, int strip_rows = usual_strip_rows);

  static constexpr int usual_strip_rows = 512;

  [[nodiscard]] RendererInfo info() const;

 private:
  void paint_strip(const DrawList& list, int top, int strip_rows, Picture& picture);

  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace tribolog::render
