#include "render/vtk/draw_list_item.h"

#include <cmath>

#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkFreeTypeTools.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkStdString.h>
#include <vtkTextRenderer.h>
#include <vtkTransform2D.h>

#include "render/figure/draw_list.h"

namespace tribolog::render::vtk {
namespace {

constexpr int dots_per_inch = 72;

}  // namespace

vtkStandardNewMacro(DrawListItem);

void DrawListItem::show(const figure::DrawList* list, const text::Font* font, int top,
                        int window_height) {
  list_ = list;
  font_ = font;
  top_ = top;
  window_height_ = window_height;
  strip_.show_rows(top, top + window_height);
  Modified();
}

// VTK's 2D projection maps [0.5, n - 0.5] to n pixels; this undoes it.
float DrawListItem::vtk_x(double x) const {
  return static_cast<float>(0.5 + x * (list_->width - 1.0) / list_->width);
}
float DrawListItem::vtk_y(double y) const {
  const double above_bottom = window_height_ - (y - top_);
  return static_cast<float>(0.5 + above_bottom * (window_height_ - 1.0) / window_height_);
}

bool DrawListItem::is_in_window(const figure::PixelBox& box) const {
  constexpr double reach = 8;  // ink may lie a little outside of a text's box
  return box.bottom + reach > top_ && box.top - reach < top_ + window_height_;
}

bool DrawListItem::Paint(vtkContext2D* context) {
  context->GetPen()->SetLineType(vtkPen::NO_PEN);
  figure::Colour pending{};
  const auto use = [&](figure::Colour colour) {
    if (!(colour == pending)) fill(context, pending);
    pending = colour;
  };
  for (const figure::Primitive& primitive : list_->primitives) {
    if (const auto* run = std::get_if<figure::TextRun>(&primitive)) {
      if (!is_in_window(run->box)) continue;
      fill(context, pending);
      draw_text(context, *run);
    } else if (const auto* line = std::get_if<figure::Polyline>(&primitive)) {
      use(line->colour);
      strip_.add(*line);
    } else if (const auto* ribbon = std::get_if<figure::Ribbon>(&primitive)) {
      use(ribbon->colour);
      strip_.add(*ribbon);
    } else if (const auto* polygon = std::get_if<figure::Polygon>(&primitive)) {
      use(polygon->colour);
      strip_.add(*polygon);
    } else if (const auto* markers = std::get_if<figure::Markers>(&primitive)) {
      if (figure::has_rim(*markers)) {
        use(figure::marker_rim_colour);
        strip_.add(*markers, figure::marker_rim_px);
      }
      use(markers->colour);
      strip_.add(*markers);
    }
  }
  fill(context, pending);
  return true;
}

void DrawListItem::fill(vtkContext2D* context, figure::Colour colour) {
  const std::vector<figure::PixelPoint>& points = strip_.points();
  if (points.size() >= 4) {
    std::vector<float> vertices;
    vertices.reserve(2 * points.size());
    for (const figure::PixelPoint& p : points) {
      vertices.push_back(vtk_x(p.x));
      vertices.push_back(vtk_y(p.y));
    }
    context->GetBrush()->SetColor(colour.red, colour.green, colour.blue, colour.alpha);
    context->DrawQuadStrip(vertices.data(), static_cast<int>(points.size()));
  }
  strip_.clear();
}

void DrawListItem::draw_text(vtkContext2D* context, const figure::TextRun& run) {
  if (run.text.find_first_not_of(' ') == std::string::npos) return;
  vtkTextProperty* property = property_;
  property->SetFontFamily(VTK_FONT_FILE);
  property->SetFontFile(font_->file(run.bold ? text::Weight::bold : text::Weight::regular).c_str());
  property->SetFontSize(run.size);
  property->SetBold(0);
  property->SetItalic(0);
  property->SetColor(run.colour.red / 255.0, run.colour.green / 255.0, run.colour.blue / 255.0);
  property->SetJustificationToLeft();
  if (run.upright) {
    property->SetOrientation(0);
    property->SetVerticalJustificationToBottom();
  } else {
    property->SetOrientation(90);
    property->SetVerticalJustificationToTop();
  }
  // The projection stretches the image of a long text by a fraction of a pixel, and what lies
  // beyond its end repeats its beginning: spaces there make that invisible.
  const vtkStdString padded(" " + run.text + " ");
  vtkTextRenderer::Metrics metrics;
  if (!vtkFreeTypeTools::GetInstance()->GetMetrics(property, padded, dots_per_inch, metrics)) {
    return;
  }
  const double space =
      font_->measure(run.bold ? text::Weight::bold : text::Weight::regular, run.size, U' ').advance;
  // VTK places the image of the text by its lower left corner; its baseline starts inside.
  const int inside_x = metrics.BottomLeft.GetX() - metrics.Descent.GetX() - metrics.BoundingBox[0];
  const int inside_y = metrics.BottomLeft.GetY() - metrics.Descent.GetY() - metrics.BoundingBox[2];
  const double x = run.baseline.x - inside_x - (run.upright ? space : 0.0);
  const double y = run.baseline.y + inside_y + (run.upright ? 0.0 : space);
  // VTK rounds the place of a text down, but not a translation.
  vtkNew<vtkTransform2D> exact_place;
  exact_place->Translate(vtk_x(x), vtk_y(y));
  context->PushMatrix();
  context->AppendTransform(exact_place);
  context->ApplyTextProp(property);
  context->DrawString(0.0F, 0.0F, padded);
  context->PopMatrix();
}

}  // namespace tribolog::render::vtk
