#include "render/paint/painter.h"

#include <memory>

#include "base/error.h"
#include "base/program_module.h"

namespace tribolog::render::paint {

std::unique_ptr<Painter> make_painter(const text::Font& font, PainterThreads threads) {
  try {
    void* const make =
        function_of({"tribolog_vtk", TRIBOLOG_GRAPHICS_PACKAGES}, "tribolog_vtk_painter");
    return std::unique_ptr<Painter>(
        reinterpret_cast<decltype(&tribolog_vtk_painter)>(make)(font, threads));
  } catch (const MissingModule& missing) {
    throw FigureError(stated_by(missing));
  }
}

}  // namespace tribolog::render::paint
