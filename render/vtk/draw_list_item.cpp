#include "render/vtk/draw_list_item.h"

#include <cmath>
#include <vector>

#include <vtkContext2D.h>
#include <vtkFreeTypeTools.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkStdString.h>
#include <vtkTextRenderer.h>
#include <vtkTransform2D.h>

#include "render/figure/draw_list.h"
#include "render/vtk/triangle_device.h"

namespace tribolog::render::vtk {
namespace {

constexpr int dots_per_inch = 72;
constexpr std::size_t colours_at_once = 1 << 18;  // bytes: more would be copied through all caches

/// As of the triangles that tie two parts.
bool has_no_area(figure::PixelPoint a, figure::PixelPoint b, figure::PixelPoint c) {
  return (b.x - a.x) * (c.y - a.y) == (c.x - a.x) * (b.y - a.y);
}

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
  for (const figure::Primitive& primitive : list_->primitives) {
    if (const auto* run = std::get_if<figure::TextRun>(&primitive)) {
      if (!is_in_window(run->box)) continue;
      fill(context);
      draw_text(context, *run);
    } else if (const auto* line = std::get_if<figure::Polyline>(&primitive)) {
      strip_.use(line->colour);
      strip_.add(*line);
    } else if (const auto* ribbon = std::get_if<figure::Ribbon>(&primitive)) {
      strip_.use(ribbon->colour);
      strip_.add(*ribbon);
    } else if (const auto* polygon = std::get_if<figure::Polygon>(&primitive)) {
      strip_.use(polygon->colour);
      strip_.add(*polygon);
    } else if (const auto* markers = std::get_if<figure::Markers>(&primitive)) {
      if (figure::has_rim(*markers)) {
        strip_.use(figure::marker_rim_colour);
        strip_.add(*markers, figure::marker_rim_px);
      }
      strip_.use(markers->colour);
      strip_.add(*markers);
    }
  }
  fill(context);
  return true;
}

void DrawListItem::fill(vtkContext2D* context) {
  const std::vector<StripPoint>& points = strip_.points();
  auto* const device = TriangleDevice::SafeDownCast(context->GetDevice());
  std::vector<float> corners;
  std::vector<unsigned char> colours;
  const auto draw = [&] {
    if (!colours.empty()) device->draw_triangles(corners, colours);
    corners.clear();
    colours.clear();
  };
  for (std::size_t i = 2; i < points.size(); ++i) {
    if (has_no_area(points[i - 2].at, points[i - 1].at, points[i].at)) continue;
    for (const std::size_t k : {i - 2, i - 1, i}) {
      const auto& [at, cover, colour] = points[k];
      corners.insert(corners.end(), {vtk_x(at.x), vtk_y(at.y)});
      colours.insert(colours.end(), {colour.red, colour.green, colour.blue, colour.alpha});
    }
    if (colours.size() >= colours_at_once) draw();
  }
  draw();
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
