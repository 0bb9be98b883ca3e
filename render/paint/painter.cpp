#include "render/paint/painter.h"

#include <algorithm>

#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkFreeTypeTools.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVersion.h>

#include "error.h"
#include "render/paint/draw_list_item.h"
#include "render/paint/gl_context.h"
#include "render/paint/headless_window.h"
#include "render/paint/scene_painter.h"
#include "render/paint/vtk_messages.h"

namespace tribolog::render {
namespace {

constexpr int samples_per_pixel = 4;          // llvmpipe has no more
constexpr double outline_share = 1.8 / 1600;  // of the picture's width: outlines of solid parts

}  // namespace

struct Painter::Parts {
  explicit Parts(const Font& used) : font(used), context(make_gl_context()) {}

  const Font& font;
  std::unique_ptr<GlContext> context;  // outlives the window below
  vtkNew<VtkMessages> messages;
  vtkNew<HeadlessWindow> window;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkContextActor> actor;
  vtkNew<DrawListItem> item;
};

Painter::Painter(const Font& font) : parts_(std::make_unique<Parts>(font)) {
  vtkOutputWindow::SetInstance(parts_->messages);
  // FreeType's glyph cache may start out believing that it is full and reload every glyph.
  vtkFreeTypeTools::GetInstance()->SetMaximumNumberOfBytes(~0UL);
  parts_->window->attach(parts_->context.get());
  parts_->window->SetMultiSamples(samples_per_pixel);
  parts_->window->SwapBuffersOff();
  parts_->renderer->SetBackground(1, 1, 1);
  parts_->window->AddRenderer(parts_->renderer);
  parts_->renderer->AddActor(parts_->actor);
  parts_->actor->GetScene()->SetRenderer(parts_->renderer);
  parts_->actor->GetScene()->AddItem(parts_->item);
}

Painter::~Painter() = default;

Picture Painter::paint(const DrawList& list, int strip_rows) {
  Picture picture{list.width, list.height, {}, list.width_mm};
  picture.rgb.resize(3 * static_cast<std::size_t>(list.width) *
                     static_cast<std::size_t>(list.height));
  parts_->window->SetSize(list.width, strip_rows);
  std::unique_ptr<ScenePainter> scene;
  if (list.scene) {
    const double outline_px = std::max(1.0, outline_share * list.width);
    scene = std::make_unique<ScenePainter>(parts_->renderer, *list.scene, outline_px);
  }
  parts_->window->keep_depth(scene != nullptr);
  for (int top = 0; top < list.height; top += strip_rows) {
    if (scene) scene->show_rows(list.width, top, strip_rows);
    paint_strip(list, top, strip_rows, picture);
  }
  const std::string error = parts_->messages->take_error();
  if (!error.empty()) throw FigureError("VTK: " + error);
  return picture;
}

void Painter::paint_strip(const DrawList& list, int top, int strip_rows, Picture& picture) {
  parts_->item->show(&list, &parts_->font, top, strip_rows);
  parts_->window->Render();
  vtkNew<vtkUnsignedCharArray> pixels;
  parts_->window->GetPixelData(0, 0, list.width - 1, strip_rows - 1, 0, pixels, 0);
  const std::size_t row = 3 * static_cast<std::size_t>(list.width);
  if (static_cast<std::size_t>(pixels->GetNumberOfValues()) !=
      row * static_cast<std::size_t>(strip_rows)) {
    throw FigureError("VTK gave a picture of the wrong size");
  }
  const unsigned char* bottom_up = pixels->GetPointer(0);
  const int rows = std::min(strip_rows, list.height - top);
  for (int y = 0; y < rows; ++y) {
    std::copy_n(bottom_up + static_cast<std::size_t>(strip_rows - 1 - y) * row, row,
                picture.rgb.begin() + static_cast<std::ptrdiff_t>(row) * (top + y));
  }
}

RendererInfo Painter::info() const {
  return {vtkVersion::GetVTKVersion(),        parts_->context->back_end(),
          parts_->context->gl_version(),      parts_->context->gl_renderer(),
          parts_->font.file(Weight::regular), Font::freetype_version()};
}

}  // namespace tribolog::render
