#include "render/vector/vector_canvas.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>
#include <libdeflate.h>

#include "base/error.h"
#include "render/figure/draw_list.h"
#include "render/text/characters.h"

namespace tribolog::render::vector {

std::string short_number(double value, int digits) {
  if (!std::isfinite(value)) return "0";
  std::string text = fmt::format("{:.{}f}", value, digits);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

std::string place_of(figure::PixelPoint p) { return short_number(p.x) + " " + short_number(p.y); }

namespace {

using Points = VectorCanvas::Points;

Points outline_of(const figure::Ribbon& ribbon, std::size_t from, std::size_t to) {
  const auto part = [&](const Points& edge) {
    return Points(edge.begin() + static_cast<std::ptrdiff_t>(from),
                  edge.begin() + static_cast<std::ptrdiff_t>(to) + 1);
  };
  Points outline = part(ribbon.edge_a);
  const Points back = part(ribbon.edge_b);
  outline.insert(outline.end(), back.rbegin(), back.rend());
  return outline;
}

class ListPainter {
 public:
  explicit ListPainter(VectorCanvas& canvas) : canvas_(canvas) {}

  void operator()(const figure::Polyline& line) {
    if (line.points.size() > 1) {
      canvas_.stroke({line.points}, {line.width, line.colour, line.dashes});
    }
  }

  /// A band that turns back covers itself; each stretch between two turns is filled alone.
  void operator()(const figure::Ribbon& ribbon) {
    const Points& edge = ribbon.edge_a;
    if (edge.size() < 2) return;
    std::size_t from = 0;
    for (std::size_t i = 1; i + 1 < edge.size(); ++i) {
      const bool turns = (edge[i].x - edge[i - 1].x) * (edge[i + 1].x - edge[i].x) < 0;
      if (!turns) continue;
      canvas_.fill({outline_of(ribbon, from, i)}, ribbon.colour);
      from = i;
    }
    canvas_.fill({outline_of(ribbon, from, edge.size() - 1)}, ribbon.colour);
  }

  void operator()(const figure::Polygon& polygon) {
    if (polygon.outline.size() > 2) canvas_.fill({polygon.outline}, polygon.colour);
  }

  void operator()(const figure::Markers& markers) {
    if (markers.shape == figure::Marker::none || markers.centres.empty()) return;
    if (figure::has_rim(markers)) paint(markers, figure::marker_rim_colour, figure::marker_rim_px);
    paint(markers, markers.colour, 0.0);
  }

  void operator()(const figure::TextRun& run) {
    if (run.text.find_first_not_of(' ') != std::string::npos) canvas_.text(run);
  }

 private:
  void paint(const figure::Markers& markers, figure::Colour colour, double grow) {
    const double radius = figure::marker_radius(markers, grow);
    if (colour.alpha < 255) {  // where two lie on each other, both are seen
      for (const figure::PixelPoint& centre : markers.centres) {
        figure::Markers one = markers;
        one.centres = {centre};
        paint_as_one(one, colour, radius, grow);
      }
      return;
    }
    paint_as_one(markers, colour, radius, grow);
  }

  void paint_as_one(const figure::Markers& markers, figure::Colour colour, double radius,
                    double grow) {
    if (markers.shape == figure::Marker::circle) {
      canvas_.fill_discs(markers.centres, radius, colour);
      return;
    }
    std::vector<Points> parts;
    for (const figure::PixelPoint& centre : markers.centres) {
      if (!figure::is_stroked(markers.shape)) {
        parts.push_back(figure::marker_corners(markers.shape, centre, radius));
        continue;
      }
      for (const auto& [from, to] : figure::marker_strokes(markers, centre, grow).lines) {
        parts.push_back({from, to});
      }
    }
    if (figure::is_stroked(markers.shape)) {
      canvas_.stroke(parts, {figure::marker_strokes(markers, {}, grow).thickness, colour, {}});
    } else {
      canvas_.fill(parts, colour);
    }
  }

  VectorCanvas& canvas_;
};

}  // namespace

void paint_on(VectorCanvas& canvas, const figure::DrawList& list) {
  ListPainter painter(canvas);
  for (const figure::Primitive& primitive : list.primitives) std::visit(painter, primitive);
}

// Faces.

namespace {

text::Weight weight_of(const figure::TextRun& run) {
  return run.bold ? text::Weight::bold : text::Weight::regular;
}

std::map<char32_t, unsigned> glyphs_of(const text::Font& font, text::Weight weight,
                                       const std::set<char32_t>& characters) {
  std::map<char32_t, unsigned> out;
  for (const char32_t c : characters) out.emplace(c, font.glyph(weight, c));
  return out;
}

/// Six letters, as names of subsets in PDF have them.
std::string tag_of(const std::map<char32_t, unsigned>& glyphs) {
  std::uint32_t sum = 0;
  for (const auto& [character, glyph] : glyphs) {
    const std::uint32_t pair[] = {character, glyph};
    sum = libdeflate_crc32(sum, pair, sizeof pair);
  }
  std::string tag;
  for (int i = 0; i < 6; ++i) {
    tag += static_cast<char>('A' + sum % 26);
    sum /= 26;
  }
  return tag;
}

}  // namespace

DocumentFace::DocumentFace(const text::Font& font, text::Weight weight,
                           const std::set<char32_t>& characters)
    : weight_(weight),
      file_(std::make_unique<TrueTypeFile>(font.file(weight))),
      originals_(glyphs_of(font, weight, characters)) {
  name_ = fmt::format("{}+DejaVuSans{}", tag_of(originals_),
                      weight == text::Weight::bold ? "Bold" : "");
  subset_ = true_type_subset(*file_, originals_, name_);
}

double DocumentFace::advance_em(char32_t c) const {
  return static_cast<double>(file_->advance(original(c))) / file_->units_per_em();
}

std::vector<SetGlyph> DocumentFace::set(const figure::TextRun& run) const {
  std::vector<SetGlyph> out;
  unsigned previous = 0;
  for (const char32_t c : text::decode_utf8(run.text).text) {
    const unsigned glyph = original(c);
    const double kerning =
        out.empty() ? 0.0
                    : static_cast<double>(file_->kerning(previous, glyph)) / file_->units_per_em();
    out.push_back({subset_.glyphs.at(c), kerning});
    previous = glyph;
  }
  return out;
}

double DocumentFace::letter_spacing(const figure::TextRun& run) const {
  constexpr double most_em = 0.1;
  double natural_em = 0;
  const std::u32string text = text::decode_utf8(run.text).text;
  for (const char32_t c : text) natural_em += advance_em(c);
  for (const SetGlyph& one : set(run)) natural_em += one.kerning_em;
  if (text.empty()) return 0.0;
  const double length = run.upright ? run.box.width() : run.box.height();
  const double most = most_em * run.size;
  return std::clamp((length - natural_em * run.size) / static_cast<double>(text.size()), -most,
                    most);
}

std::vector<DocumentFace> document_faces(const figure::DrawList& list, const text::Font& font) {
  std::map<text::Weight, std::set<char32_t>> characters;
  for (const figure::Primitive& primitive : list.primitives) {
    const auto* run = std::get_if<figure::TextRun>(&primitive);
    if (run == nullptr) continue;
    for (const char32_t c : text::decode_utf8(run->text).text)
      characters[weight_of(*run)].insert(c);
  }
  std::vector<DocumentFace> faces;
  for (const auto& [weight, used] : characters) faces.emplace_back(font, weight, used);
  return faces;
}

const DocumentFace& face_of(const std::vector<DocumentFace>& faces, const figure::TextRun& run) {
  const auto found = std::find_if(faces.begin(), faces.end(), [&](const DocumentFace& face) {
    return face.weight() == weight_of(run);
  });
  if (found == faces.end()) throw FigureError({"drawing.text_without_font"});
  return *found;
}

}  // namespace tribolog::render::vector
