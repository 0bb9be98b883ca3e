#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/error.h"
#include "render/vector/pdf_objects.h"
#include "render/vector/vector_canvas.h"
#include "render/vector/vector_document.h"

namespace tribolog::render::vector {

// A draw list as the content of a PDF page.

namespace {

/// Writes operators in pixels of the list, y downwards: the page turns them over.
class PdfCanvas : public VectorCanvas {
 public:
  explicit PdfCanvas(const std::vector<DocumentFace>& faces) : faces_(faces) {}

  void fill(const std::vector<Points>& outlines, figure::Colour colour) override;
  void fill_discs(const Points& centres, double radius, figure::Colour colour) override;
  void stroke(const std::vector<Points>& lines, const StrokeLook& look) override;
  void text(const figure::TextRun& run) override;

  [[nodiscard]] const std::string& content() const { return out_; }
  /// What the page needs as graphics state "/A50" for each.
  [[nodiscard]] const std::set<int>& alphas() const { return alphas_; }

 private:
  void use_alpha(int alpha);

  const std::vector<DocumentFace>& faces_;
  std::string out_;
  std::set<int> alphas_;
  int alpha_{255};
};

std::string colour_of(figure::Colour colour, const char* fill_or_stroke) {
  const auto part = [](std::uint8_t value) { return short_number(value / 255.0, 4); };
  return fmt::format("{} {} {} {}\n", part(colour.red), part(colour.green), part(colour.blue),
                     fill_or_stroke);
}

void put_pdf_points(std::string& out, const VectorCanvas::Points& points, bool closed) {
  const std::size_t count =
      closed && points.front() == points.back() ? points.size() - 1 : points.size();
  for (std::size_t i = 0; i < count; ++i) {
    out += fmt::format("{} {}\n", place_of(points[i]), i == 0 ? 'm' : 'l');
  }
  if (closed) out += "h\n";
}

/// Four curves, nowhere farther from the circle than a 3,000th of its radius.
void put_disc(std::string& out, figure::PixelPoint c, double r) {
  const double k = r * 4.0 / 3.0 * (std::sqrt(2.0) - 1.0);
  const auto curve = [&](figure::PixelPoint a, figure::PixelPoint b, figure::PixelPoint end) {
    out += fmt::format("{} {} {} c\n", place_of(a), place_of(b), place_of(end));
  };
  out += fmt::format("{} m\n", place_of({c.x + r, c.y}));
  curve({c.x + r, c.y + k}, {c.x + k, c.y + r}, {c.x, c.y + r});
  curve({c.x - k, c.y + r}, {c.x - r, c.y + k}, {c.x - r, c.y});
  curve({c.x - r, c.y - k}, {c.x - k, c.y - r}, {c.x, c.y - r});
  curve({c.x + k, c.y - r}, {c.x + r, c.y - k}, {c.x + r, c.y});
  out += "h\n";
}

/// "/F0" for the regular weight, "/F1" for the bold one.
const char* pdf_font_name(text::Weight weight) {
  return weight == text::Weight::bold ? "/F1" : "/F0";
}

void PdfCanvas::use_alpha(int alpha) {
  if (alpha == alpha_) return;
  alphas_.insert(alpha);
  out_ += fmt::format("/A{} gs\n", alpha);
  alpha_ = alpha;
}

void PdfCanvas::fill(const std::vector<Points>& outlines, figure::Colour colour) {
  use_alpha(colour.alpha);
  out_ += colour_of(colour, "rg");
  for (const Points& outline : outlines) put_pdf_points(out_, outline, true);
  out_ += "f\n";
}

void PdfCanvas::fill_discs(const Points& centres, double radius, figure::Colour colour) {
  use_alpha(colour.alpha);
  out_ += colour_of(colour, "rg");
  for (const figure::PixelPoint& centre : centres) put_disc(out_, centre, radius);
  out_ += "f\n";
}

void PdfCanvas::stroke(const std::vector<Points>& lines, const StrokeLook& look) {
  use_alpha(look.colour.alpha);
  out_ += colour_of(look.colour, "RG");
  out_ += short_number(look.width) + " w [";
  for (const double length : look.dashes) out_ += short_number(length) + " ";
  out_ += "] 0 d\n";
  for (const Points& line : lines) put_pdf_points(out_, line, is_closed(line, look));
  out_ += "S\n";
}

void PdfCanvas::text(const figure::TextRun& run) {
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

constexpr double points_per_mm = 72.0 / 25.4;

/// Fonts, transparency and the picture below, by the names that the content uses.
std::string resources_of(PdfFile& file, const std::vector<DocumentFace>& faces,
                         const PdfCanvas& canvas, const std::vector<std::byte>& solid_parts) {
  std::string fonts;
  for (const DocumentFace& face : faces) {
    fonts +=
        fmt::format("{} {} ", pdf_font_name(face.weight()), pdf_reference(add_font(file, face)));
  }
  std::string states;
  for (const int alpha : canvas.alphas()) {
    const std::string share = short_number(alpha / 255.0, 4);
    states += fmt::format("/A{} << /ca {} /CA {} >> ", alpha, share, share);
  }
  std::string out = fmt::format("<< /Font << {}>> /ExtGState << {}>>", fonts, states);
  if (!solid_parts.empty()) {
    out += fmt::format(" /XObject << /Solid {} >>", pdf_reference(add_picture(file, solid_parts)));
  }
  return out + " >>";
}

}  // namespace

std::string pdf_document(const figure::DrawList& list, const DocumentTexts& texts,
                         const text::Font& font, const std::vector<std::byte>& solid_parts) {
  if (list.scene && solid_parts.empty()) {
    throw FigureError({"drawing.solid_parts_not_drawn", {{"format", "PDF"}}});
  }
  const double scale = points_per_mm * list.width_mm / list.width;
  const std::string width = short_number(scale * list.width, 3);
  const std::string height = short_number(scale * list.height, 3);
  const std::vector<DocumentFace> faces = document_faces(list, font);
  PdfCanvas canvas(faces);
  paint_on(canvas, list);
  std::string content = fmt::format("/Figure << /MCID 0 >> BDC\nq\n{0} 0 0 -{0} 0 {1} cm\n1 j\n",
                                    short_number(scale, 6), height);
  if (!solid_parts.empty()) {
    content += fmt::format("q {0} 0 0 -{1} 0 {1} cm /Solid Do Q\n", list.width, list.height);
  }
  content += canvas.content() + "Q\nEMC\n";

  PdfFile file;
  const int catalogue = file.reserve();
  const int pages = file.reserve();
  const int page = file.reserve();
  const int structure = file.reserve();
  const int figure = file.reserve();
  file.write(catalogue,
             fmt::format("<< /Type /Catalog /Pages {} /Lang (en) /MarkInfo << /Marked true >> "
                         "/StructTreeRoot {} /ViewerPreferences << /DisplayDocTitle true >> >>",
                         pdf_reference(pages), pdf_reference(structure)));
  file.write(pages, fmt::format("<< /Type /Pages /Kids [{}] /Count 1 >>", pdf_reference(page)));
  file.write(structure,
             fmt::format("<< /Type /StructTreeRoot /K [{0}] /ParentTree << /Nums [0 [{0}]] >> >>",
                         pdf_reference(figure)));
  file.write(figure,
             fmt::format("<< /Type /StructElem /S /Figure /P {} /Pg {} /K 0 /T {} /Alt {} "
                         "/A << /O /Layout /Placement /Block /BBox [0 0 {} {}] >> >>",
                         pdf_reference(structure), pdf_reference(page), pdf_text(texts.title),
                         pdf_text(texts.description), width, height));
  const int drawn = file.add_stream(content);
  file.write(page, fmt::format("<< /Type /Page /Parent {} /MediaBox [0 0 {} {}] /Contents {} "
                               "/StructParents 0 /Group << /S /Transparency /CS /DeviceRGB >> "
                               "/Resources {} >>",
                               pdf_reference(pages), width, height, pdf_reference(drawn),
                               resources_of(file, faces, canvas, solid_parts)));
  const int information =
      file.add(fmt::format("<< /Title {} /Producer (tribolog) >>", pdf_text(texts.title)));
  return file.finish(catalogue, information);
}

}  // namespace tribolog::render::vector
