#include <cmath>
#include <optional>
#include <span>
#include <string_view>

#include <fmt/format.h>

#include "base/encodings.h"
#include "base/error.h"
#include "render/text/characters.h"
#include "render/vector/vector_canvas.h"
#include "render/vector/vector_document.h"

namespace tribolog::render::vector {
namespace {

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text::encode_utf8(text::decode_utf8(text).text)) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::string paint_of(const char* what, figure::Colour colour) {
  std::string out =
      fmt::format(" {}=\"#{:02x}{:02x}{:02x}\"", what, colour.red, colour.green, colour.blue);
  if (colour.alpha < 255) {
    out += fmt::format(" {}-opacity=\"{}\"", what, short_number(colour.alpha / 255.0, 3));
  }
  return out;
}

void put_svg_points(std::string& path, const VectorCanvas::Points& points, bool closed) {
  path += 'M';
  const std::size_t count =
      closed && points.front() == points.back() ? points.size() - 1 : points.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) path += ' ';
    path += place_of(points[i]);
  }
  if (closed) path += 'Z';
}

class SvgCanvas : public VectorCanvas {
 public:
  SvgCanvas(std::string& out, const std::vector<DocumentFace>& faces) : out_(out), faces_(faces) {}

  void fill(const std::vector<Points>& outlines, figure::Colour colour) override {
    finish();
    std::string path;
    for (const Points& outline : outlines) put_svg_points(path, outline, true);
    out_ += fmt::format("<path{} d=\"{}\"/>\n", paint_of("fill", colour), path);
  }

  void fill_discs(const Points& centres, double radius, figure::Colour colour) override {
    finish();
    const std::string r = short_number(radius);
    const std::string across = short_number(2 * radius);
    std::string path;
    for (const figure::PixelPoint& c : centres) {
      path += fmt::format("M{}a{} {} 0 1 0 {} 0a{} {} 0 1 0 -{} 0Z", place_of({c.x - radius, c.y}),
                          r, r, across, r, r, across);
    }
    out_ += fmt::format("<path{} d=\"{}\"/>\n", paint_of("fill", colour), path);
  }

  void stroke(const std::vector<Points>& lines, const StrokeLook& look) override {
    finish();
    std::string path;
    for (const Points& line : lines) put_svg_points(path, line, is_closed(line, look));
    std::string dashes;
    for (const double length : look.dashes) {
      dashes += fmt::format("{}{}", dashes.empty() ? "" : " ", short_number(length));
    }
    if (!dashes.empty()) dashes = fmt::format(" stroke-dasharray=\"{}\"", dashes);
    out_ += fmt::format("<path fill=\"none\"{} stroke-width=\"{}\"{} d=\"{}\"/>\n",
                        paint_of("stroke", look.colour), short_number(look.width), dashes, path);
  }

  void text(const figure::TextRun& run) override {
    if (continues(run)) {
      const figure::PixelPoint at = along_first(run.baseline);
      out_ += fmt::format("<tspan x=\"{}\" y=\"{}\"{}>{}</tspan>", short_number(at.x),
                          short_number(at.y), look_of(run), escaped(run.text));
    } else {
      finish();
      first_ = run;
      const std::string place =
          run.upright
              ? fmt::format("x=\"{}\" y=\"{}\"", short_number(run.baseline.x),
                            short_number(run.baseline.y))
              : fmt::format("transform=\"translate({}) rotate(-90)\"", place_of(run.baseline));
      out_ += fmt::format("<text xml:space=\"preserve\" {}{}>{}", place, look_of(run),
                          escaped(run.text));
    }
    last_ = run;
  }

  /// Ends a text that a further run could have continued.
  void finish() {
    if (last_) out_ += "</text>\n";
    last_.reset();
  }

 private:
  /// Runs of one line become one text, which can be searched and copied as such.
  [[nodiscard]] bool continues(const figure::TextRun& run) const {
    if (!last_ || !(last_->owner == run.owner) || last_->upright != run.upright) return false;
    constexpr double rounding_px = 1.5;
    const double gap =
        run.upright ? run.baseline.x - last_->box.right : last_->box.top - run.baseline.y;
    const double shift =
        run.upright ? run.baseline.y - first_.baseline.y : run.baseline.x - first_.baseline.x;
    return std::abs(gap) < rounding_px && std::abs(shift) < 0.5 * first_.size;
  }

  /// In the axes of a text that is turned, which begin at its first run.
  [[nodiscard]] figure::PixelPoint along_first(figure::PixelPoint p) const {
    if (first_.upright) return p;
    return {first_.baseline.y - p.y, p.x - first_.baseline.x};
  }

  [[nodiscard]] std::string look_of(const figure::TextRun& run) const {
    figure::Colour colour = run.colour;
    colour.alpha = 255;  // as the painter of pictures has it
    return fmt::format("{} font-size=\"{}\"{} letter-spacing=\"{}\"", paint_of("fill", colour),
                       run.size, run.bold ? " font-weight=\"bold\"" : "",
                       short_number(face_of(faces_, run).letter_spacing(run), 3));
  }

  std::string& out_;
  const std::vector<DocumentFace>& faces_;
  figure::TextRun first_;
  std::optional<figure::TextRun> last_;
};

std::string in_base64(std::string_view bytes) {
  return base64(std::as_bytes(std::span(bytes.data(), bytes.size())));
}

/// Both weights under one name, in front of the same font where the reader has it.
std::string family_of(const std::vector<DocumentFace>& faces) {
  std::string name = "tribolog";
  for (const DocumentFace& face : faces) name += fmt::format("-{}", face.name().substr(0, 6));
  return name;
}

std::string font_style(const std::vector<DocumentFace>& faces) {
  std::string out;
  for (const DocumentFace& face : faces) {
    out += fmt::format(
        "@font-face{{font-family:\"{}\";font-weight:{};src:url(data:font/ttf;base64,{})}}\n",
        family_of(faces), face.weight() == text::Weight::bold ? "bold" : "normal",
        in_base64(face.subset().bytes));
  }
  return out;
}

}  // namespace

std::string svg_document(const figure::DrawList& list, const DocumentTexts& texts,
                         const text::Font& font, const std::vector<std::byte>& solid_parts) {
  if (list.scene && solid_parts.empty()) {
    throw FigureError({"drawing.solid_parts_not_drawn", {{"format", "SVG"}}});
  }
  const std::vector<DocumentFace> faces = document_faces(list, font);
  const double height_mm = list.width_mm * list.height / list.width;
  const std::string id = escaped(texts.id);
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}mm\" height=\"{}mm\" "
      "viewBox=\"0 0 {} {}\" role=\"img\" aria-labelledby=\"{}-title {}-desc\">\n<title "
      "id=\"{}-title\">{}</title>\n<desc "
      "id=\"{}-desc\">{}</desc>\n",
      short_number(list.width_mm, 3), short_number(height_mm, 3), list.width, list.height, id, id,
      id, escaped(texts.title), id, escaped(texts.description));
  if (!faces.empty()) out += fmt::format("<style>\n{}</style>\n", font_style(faces));
  out += fmt::format("<rect width=\"{}\" height=\"{}\" fill=\"#fff\"/>\n", list.width, list.height);
  if (!solid_parts.empty()) {
    out += fmt::format("<image width=\"{}\" height=\"{}\" href=\"data:image/png;base64,{}\"/>\n",
                       list.width, list.height, base64(solid_parts));
  }
  out +=
      fmt::format("<g font-family=\"{}, 'DejaVu Sans', sans-serif\" stroke-linejoin=\"round\">\n",
                  family_of(faces));
  SvgCanvas canvas(out, faces);
  paint_on(canvas, list);
  canvas.finish();
  return out + "</g>\n</svg>\n";
}

}  // namespace tribolog::render::vector
