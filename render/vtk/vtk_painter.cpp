#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>

#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkFreeTypeTools.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVersion.h>

#include "base/error.h"
#include "render/paint/painter.h"
#include "render/vtk/draw_list_item.h"
#include "render/vtk/gl_context.h"
#include "render/vtk/headless_window.h"
#include "render/vtk/scene_painter.h"
#include "render/vtk/triangle_device.h"

namespace tribolog::render::vtk {

// Keeps what VTK has to say, instead of letting it print.

namespace {

class VtkMessages : public vtkOutputWindow {
 public:
  static VtkMessages* New();
  vtkTypeMacro(VtkMessages, vtkOutputWindow)

      void DisplayText(const char* text) override;
  void DisplayErrorText(const char* text) override;
  void DisplayWarningText(const char* text) override;
  void DisplayGenericWarningText(const char* text) override;
  void DisplayDebugText(const char*) override {}

  /// First error since the last call, on one line; empty if there was none.
  std::string take_error();

  VtkMessages(const VtkMessages&) = delete;
  VtkMessages& operator=(const VtkMessages&) = delete;

 protected:
  VtkMessages() = default;
  ~VtkMessages() override = default;

 private:
  std::string first_error_;
};

vtkStandardNewMacro(VtkMessages);

void VtkMessages::DisplayErrorText(const char* text) {
  if (!first_error_.empty() || text == nullptr) return;
  first_error_ = text;
  std::replace_if(
      first_error_.begin(), first_error_.end(),
      [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
  first_error_ = first_error_.substr(0, 300);
}

// Nothing below an error changes a picture.
void VtkMessages::DisplayText(const char*) {}
void VtkMessages::DisplayWarningText(const char*) {}
void VtkMessages::DisplayGenericWarningText(const char*) {}

std::string VtkMessages::take_error() { return std::exchange(first_error_, {}); }

constexpr int samples_of_scenes = 4;          // a pixel; llvmpipe has no more
constexpr double outline_share = 1.8 / 1600;  // of the picture's width: outlines of solid parts

class VtkPainter final : public paint::Painter {
 public:
  explicit VtkPainter(const text::Font& font);
  using paint::Painter::paint;
  figure::Picture paint(const figure::DrawList& list, int strip_rows) override;
  [[nodiscard]] figure::RendererInfo info() const override;

 private:
  void paint_strip(const figure::DrawList& list, int top, int strip_rows, figure::Picture& picture);

  const text::Font& font_;
  std::unique_ptr<GlContext> context_;  // outlives the window below
  vtkNew<VtkMessages> messages_;
  vtkNew<HeadlessWindow> window_;
  vtkNew<vtkRenderer> renderer_;
  vtkNew<TriangleDevice> device_;
  vtkNew<vtkContextActor> actor_;
  vtkNew<DrawListItem> item_;
};

VtkPainter::VtkPainter(const text::Font& font) : font_(font), context_(make_gl_context()) {
  vtkOutputWindow::SetInstance(messages_);
  // FreeType's glyph cache may start out believing that it is full and reload every glyph.
  vtkFreeTypeTools::GetInstance()->SetMaximumNumberOfBytes(~0UL);
  window_->attach(context_.get());
  window_->SetMultiSamples(0);
  window_->SwapBuffersOff();
  renderer_->SetBackground(1, 1, 1);
  window_->AddRenderer(renderer_);
  renderer_->AddActor(actor_);
  actor_->SetForceDevice(device_);
  actor_->GetScene()->SetRenderer(renderer_);
  actor_->GetScene()->AddItem(item_);
}

figure::Picture VtkPainter::paint(const figure::DrawList& list, int scene_rows) {
  const int strip_rows =
      list.scene ? scene_rows : std::min(samples_of_scenes * scene_rows, list.height);
  figure::Picture picture{list.width, list.height, {}, list.width_mm};
  picture.rgb.resize(3 * static_cast<std::size_t>(list.width) *
                     static_cast<std::size_t>(list.height));
  window_->SetSize(list.width, strip_rows);
  std::unique_ptr<ScenePainter> scene;
  if (list.scene) {
    const double outline_px = std::max(1.0, outline_share * list.width);
    scene = std::make_unique<ScenePainter>(renderer_, *list.scene, outline_px);
  }
  window_->keep_depth(scene != nullptr);
  window_->SetMultiSamples(scene ? samples_of_scenes : 0);
  for (int top = 0; top < list.height; top += strip_rows) {
    if (scene) scene->show_rows(list.width, top, strip_rows);
    paint_strip(list, top, strip_rows, picture);
  }
  const std::string error = messages_->take_error();
  if (!error.empty()) throw FigureError({"drawing.vtk", {{"words", error}}});
  return picture;
}

void VtkPainter::paint_strip(const figure::DrawList& list, int top, int strip_rows,
                             figure::Picture& picture) {
  item_->show(&list, &font_, top, strip_rows);
  window_->Render();
  vtkNew<vtkUnsignedCharArray> pixels;
  // As they are stored: without alpha, each would be converted by the driver.
  window_->GetRGBACharPixelData(0, 0, list.width - 1, strip_rows - 1, 0, pixels, 0);
  const std::size_t row = 4 * static_cast<std::size_t>(list.width);
  if (static_cast<std::size_t>(pixels->GetNumberOfValues()) !=
      row * static_cast<std::size_t>(strip_rows)) {
    throw FigureError({"drawing.wrong_size"});
  }
  const unsigned char* bottom_up = pixels->GetPointer(0);
  const int rows = std::min(strip_rows, list.height - top);
  auto to = picture.rgb.begin() + static_cast<std::ptrdiff_t>(3) * list.width * top;
  for (int y = 0; y < rows; ++y) {
    const unsigned char* from = bottom_up + static_cast<std::size_t>(strip_rows - 1 - y) * row;
    for (int x = 0; x < list.width; ++x, from += 4) to = std::copy_n(from, 3, to);
  }
}

figure::RendererInfo VtkPainter::info() const {
  return {vtkVersion::GetVTKVersion(),
          context_->back_end(),
          context_->gl_version(),
          context_->gl_renderer(),
          font_.file(text::Weight::regular),
          text::Font::freetype_version()};
}

}  // namespace

}  // namespace tribolog::render::vtk

extern "C" tribolog::render::paint::Painter* tribolog_vtk_painter(
    const tribolog::render::text::Font& font, tribolog::render::paint::PainterThreads threads) {
  if (threads == tribolog::render::paint::PainterThreads::one)
    tribolog::render::vtk::keep_vtk_to_one_thread();
  return new tribolog::render::vtk::VtkPainter(font);
}
