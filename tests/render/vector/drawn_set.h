#pragma once
// The figures that the project draws, each laid out and painted.

#include <cstddef>
#include <limits>
#include <vector>

#include "figures/report_figure.h"
#include "render/figure/draw_list.h"
#include "render/figure/picture.h"
#include "render/vector/vector_document.h"

namespace tribolog::render {

struct DrawnExample {
  figures::ReportFigure figure;
  figure::DrawList list;
  figure::Picture picture;             ///< By our own painter.
  std::vector<std::byte> solid_parts;  ///< PNG, of scenes.

  [[nodiscard]] vector::DocumentTexts texts() const {
    return {figure.figure.id, figure.title, figure.alt};
  }
};

/// The paper's figures: charts, diagrams, scenes, and those of the identification.
std::vector<figures::ReportFigure> paper_set();
/// A joint over time, so many quantities of it at most, and two calibrations side by side.
std::vector<figures::ReportFigure> history_set(std::size_t most_trends = 3);
inline constexpr std::size_t every_trend = std::numeric_limits<std::size_t>::max();
/// Charts, a drawing and a scene of the paper, for the columns of a journal.
std::vector<figures::ReportFigure> publication_set();
/// Every kind of trouble that can be drawn.
std::vector<figures::ReportFigure> trouble_set();

std::vector<DrawnExample> drawn(const std::vector<figures::ReportFigure>& figures);

}  // namespace tribolog::render
