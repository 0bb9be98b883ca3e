#pragma once
// The one VTK item of the scene: draws a whole draw list.

#include <vtkContextItem.h>
#include <vtkNew.h>
#include <vtkTextProperty.h>

#include "render/figure/draw_list.h"
#include "render/text/font.h"
#include "render/vtk/strip_builder.h"

namespace tribolog::render::vtk {

class DrawListItem : public vtkContextItem {
 public:
  static DrawListItem* New();
  vtkTypeMacro(DrawListItem, vtkContextItem)

      /// Shows the part of the picture from row `top` on, as high as the window. Both must live
      /// while the item paints.
      void show(const figure::DrawList* list, const text::Font* font, int top, int window_height);

  bool Paint(vtkContext2D* context) override;

  DrawListItem(const DrawListItem&) = delete;
  DrawListItem& operator=(const DrawListItem&) = delete;

 protected:
  DrawListItem() = default;
  ~DrawListItem() override = default;

 private:
  void fill(vtkContext2D* context);
  void draw_text(vtkContext2D* context, const figure::TextRun& run);
  [[nodiscard]] bool is_in_window(const figure::PixelBox& box) const;
  [[nodiscard]] float vtk_x(double x) const;
  [[nodiscard]] float vtk_y(double y) const;

  const figure::DrawList* list_{};
  const text::Font* font_{};
  int top_{};
  int window_height_{};
  StripBuilder strip_;
  vtkNew<vtkTextProperty> property_;
};

}  // namespace tribolog::render::vtk
