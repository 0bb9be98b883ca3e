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
#include "render/paint/vtk_messages.h"

namespace tribolog::render {
namespace {

constexpr int samples_per_pixel = 4;  // llvmpipe has no more

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

Picture Painter::paint(const DrawList& list) {
  parts_->item->show(&list, &parts_->font);
  parts_->window->SetSize(list.width, list.height);
  parts_->window->Render();
  Picture picture{list.width, list.height, {}};
  vtkNew<vtkUnsignedCharArray> pixels;
  parts_->window->GetPixelData(0, 0, list.width - 1, list.height - 1, 0, pixels, 0);
  const std::string error = parts_->messages->take_error();
  if (!error.empty()) throw FigureError("VTK: " + error);
  const std::size_t row = 3 * static_cast<std::size_t>(list.width);
  const auto height = static_cast<std::size_t>(list.height);
  if (static_cast<std::size_t>(pixels->GetNumberOfValues()) != row * height) {
    throw FigureError("VTK gave a picture of the wrong size");
  }
  picture.rgb.resize(row * height);
  const unsigned char* bottom_up = pixels->GetPointer(0);
  for (std::size_t y = 0; y < height; ++y) {
    std::copy_n(bottom_up + (height - 1 - y) * row, row,
                picture.rgb.begin() + static_cast<std::ptrdiff_t>(y * row));
  }
  return picture;
}

RendererInfo Painter::info() const {
  return {vtkVersion::GetVTKVersion(),        parts_->context->back_end(),
          parts_->context->gl_version(),      parts_->context->gl_renderer(),
          parts_->font.file(Weight::regular), Font::freetype_version()};
}

}  // namespace tribolog::render
