#include "api/figure_files.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "api/drawing.h"
#include "base/enum_text.h"
#include "base/error.h"
#include "render/composition/figure_layout.h"
#include "render/composition/publication.h"
#include "render/text/font.h"
#include "render/vector/vector_document.h"

namespace tribolog::api {
namespace {

std::string text_of(const std::vector<std::byte>& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Titles and labels are quoted, and end up on a terminal.
Statement shown(const Statement& statement) {
  return with_texts(statement, [](const std::string& text) { return printable(text, 400); });
}

/// The pictures of scenes that go below their lines and texts, by the figure's place in the list.
std::map<std::size_t, render::workers::DrawnFigure> draw_solid_parts(
    const std::vector<figures::ReportFigure>& figures, render::workers::FigureRenderer* renderer) {
  std::vector<std::size_t> places;
  std::vector<render::figure::Figure> scenes;
  for (std::size_t i = 0; i < figures.size(); ++i) {
    if (!figures[i].figure.scene) continue;
    places.push_back(i);
    scenes.push_back(figures[i].figure);
  }
  std::map<std::size_t, render::workers::DrawnFigure> out;
  if (scenes.empty() || renderer == nullptr) return out;
  render::workers::DrawOptions options;
  options.solid_parts_only = true;
  std::vector<render::workers::DrawnFigure> drawn = renderer->draw(scenes, options);
  for (std::size_t k = 0; k < places.size(); ++k) out.emplace(places[k], std::move(drawn[k]));
  return out;
}

std::string ending_of(FigureFormat format) { return own_name(format); }

class VectorWriter {
 public:
  VectorWriter(std::vector<File>& files, const std::vector<FigureFormat>& formats)
      : files_(files), formats_(formats) {}

  /// @param solid_parts null for what has none
  void write(const figures::ReportFigure& figure, const render::workers::DrawnFigure* solid_parts,
             render::workers::DrawnFigure& outcome) {
    try {
      const render::figure::DrawList list = render::composition::lay_out(figure.figure, font_);
      if (outcome.warnings.empty()) {
        for (const Statement& one : list.warnings) outcome.warnings.push_back(shown(one));
      }
      std::vector<std::byte> picture;
      if (solid_parts != nullptr) {
        if (!solid_parts->error.empty()) throw FigureError(solid_parts->error);
        picture = solid_parts->png;
      }
      const render::vector::DocumentTexts texts{figure.figure.id, figure.title, figure.alt};
      for (const FigureFormat format : formats_) {
        if (format == FigureFormat::png) continue;
        files_.push_back({file_name(figure, format),
                          format == FigureFormat::svg
                              ? render::vector::svg_document(list, texts, font_, picture)
                              : render::vector::pdf_document(list, texts, font_, picture)});
      }
    } catch (const FigureError& problem) {
      if (outcome.error.empty()) outcome.error = shown(problem.statement());
    }
  }

  static std::string file_name(const figures::ReportFigure& figure, FigureFormat format) {
    return fmt::format("{}.{}", figure.figure.id, ending_of(format));
  }

 private:
  std::vector<File>& files_;
  const std::vector<FigureFormat>& formats_;
  render::text::Font font_;
};

/// The pictures go into the files; what is left of each figure is its outcome.
std::vector<render::workers::DrawnFigure> draw_pictures(
    const std::vector<figures::ReportFigure>& figures, render::workers::FigureRenderer& renderer,
    std::vector<File>& files, const Progress& progress) {
  std::vector<render::workers::DrawnFigure> drawn =
      draw(renderer, figures, [&](std::size_t done, std::size_t all) {
        if (progress) progress("drawing figures", done, all);
      });
  for (std::size_t i = 0; i < figures.size(); ++i) {
    if (!drawn[i].error.empty()) continue;
    files.push_back(
        {VectorWriter::file_name(figures[i], FigureFormat::png), text_of(drawn[i].png)});
    drawn[i].png.clear();
  }
  return drawn;
}

bool has(const std::vector<FigureFormat>& formats, FigureFormat wanted) {
  return std::find(formats.begin(), formats.end(), wanted) != formats.end();
}

}  // namespace

std::vector<figures::ReportFigure> for_publication(std::vector<figures::ReportFigure> figures) {
  const render::text::Font font;
  for (figures::ReportFigure& one : figures) {
    try {
      one.figure = render::composition::for_publication(one.figure, font);
    } catch (const FigureError&) {
      continue;
    }
  }
  return figures;
}

Figures figure_files(const std::vector<figures::ReportFigure>& figures,
                     const std::vector<FigureFormat>& formats,
                     render::workers::FigureRenderer* renderer, const Progress& progress) {
  Figures out;
  std::vector<render::workers::DrawnFigure> drawn;
  if (has(formats, FigureFormat::png)) {
    drawn = draw_pictures(figures, *renderer, out.files, progress);
  } else {
    for (const figures::ReportFigure& one : figures) drawn.emplace_back().id = one.figure.id;
  }
  if (has(formats, FigureFormat::svg) || has(formats, FigureFormat::pdf)) {
    const auto solid_parts = draw_solid_parts(figures, renderer);
    VectorWriter writer(out.files, formats);
    for (std::size_t i = 0; i < figures.size(); ++i) {
      if (progress) progress("writing figures", i, figures.size());
      const auto below = solid_parts.find(i);
      writer.write(figures[i], below == solid_parts.end() ? nullptr : &below->second, drawn[i]);
    }
  }
  out.outcomes = outcomes_of(drawn);
  return out;
}

}  // namespace tribolog::api
