#include "render/vector/pdf_canvas.h"

#include <cmath>

#include <fmt/format.h>

#include "render/vector/short_number.h"

namespace tribolog::render {
namespace {

std::string colour_of(Colour colour, const char* fill_or_stroke) {
  const auto part = [](std::uint8_t value) { return short_number(value / 255.0, 4); };
  return fmt::format("{} {} {} {}\n", part(colour.red), part(colour.green), part(colour.blue),
                     fill_or_stroke);
}

std::string place_of(PixelPoint p) {
  return fmt::format("{} {}", short_number(p.x), short_number(p.y));
}

void put_points(std::string& out, const VectorCanvas::Points& points, bool closed) {
  const std::size_t count =
      closed && points.front() == points.back() ? points.size() - 1 : points.size();
  for (std::size_t i = 0; i < count; ++i) {
    out += fmt::format("{} {}\n", place_of(points[i]), i == 0 ? 'm' : 'l');
  }
  if (closed) out += "h\n";
}

/// Four curves, nowhere farther from the circle than a 3,000th of its radius.
void put_disc(std::string& out, PixelPoint c, double r) {
  const double k = r * 4.0 / 3.0 * (std::sqrt(2.0) - 1.0);
  const auto curve = [&](PixelPoint a, PixelPoint b, PixelPoint end) {
    out += fmt::format("{} {} {} c\n", place_of(a), place_of(b), place_of(end));
  };
  out += fmt::format("{} m\n", place_of({c.x + r, c.y}));
  curve({c.x + r, c.y + k}, {c.x + k, c.y + r}, {c.x, c.y + r});
  curve({c.x - k, c.y + r}, {c.x - r, c.y + k}, {c.x - r, c.y});
  curve({c.x - r, c.y - k}, {c.x - k, c.y - r}, {c.x, c.y - r});
  curve({c.x + k, c.y - r}, {c.x + r, c.y - k}, {c.x + r, c.y});
  out += "h\n";
}

}  // namespace

const char* pdf_font_name(Weight weight) { return weight == Weight::bold ? "/F1" : "/F0"; }

void PdfCanvas::use_alpha(int alpha) {
  if (alpha == alpha_) return;
  alphas_.insert(alpha);
  out_ += fmt::format("/A{} gs\n", alpha);
  alpha_ = alpha;
}

void PdfCanvas::fill(const std::vector<Points>& outlines, Colour colour) {
  use_alpha(colour.alpha);
  out_ += colour_of(colour, "rg");
  for (const Points& outline : outlines) put_points(out_, outline, true);
  out_ += "f\n";
}

void PdfCanvas::fill_discs(const Points& centres, double radius, Colour colour) {
  use_alpha(colour.alpha);
  out_ += colour_of(colour, "rg");
  for (const PixelPoint& centre : centres) put_disc(out_, centre, radius);
  out_ += "f\n";
}

void PdfCanvas::stroke(const std::vector<Points>& lines, const StrokeLook& look) {
  use_alpha(look.colour.alpha);
  out_ += colour_of(look.colour, "RG");
  out_ += short_number(look.width) + " w [";
  for (const double length : look.dashes) out_ += short_number(length) + " ";
  out_ += "] 0 d\n";
  for (const Points& line : lines) put_points(out_, line, is_closed(line, look));
  out_ += "S\n";
}

void PdfCanvas::text(const TextRun& run) {
  const DocumentFace& face = face_of(faces_, run);
  use_alpha(255);  // as the painter of pictures has it
  out_ += colour_of(run.colour, "rg");
  // A text's own axes: along the baseline, and up from it.
  out_ += fmt::format("BT\n{} {} Tf\n{} Tc\n{} {} Tm\n[<", pdf_font_name(face.weight()), run.size,
                      short_number(face.letter_spacing(run), 3),
                      run.upright ? "1 0 0 -1" : "0 -1 -1 0", place_of(run.baseline));
  constexpr double per_em = 1000.0;
  for (const SetGlyph& one : face.set(run)) {
    const std::string back = short_number(-per_em * one.kerning_em, 0);
    if (back != "0") out_ += fmt::format("> {} <", back);
    out_ += fmt::format("{:04X}", one.glyph);
  }
  out_ += ">] TJ\nET\n";
}

}  // namespace tribolog::render
