#pragma once
// A figure of the report: the picture's description and the words that go with it.

#include <string>

#include "render/figure/figure.h"

namespace tribolog {

/// `title`, `caption`, `how_to_read` and `alt` are plain UTF-8 text: no markup, no HTML.
/// Texts inside `figure` use the markup of render/figure.h.
struct ReportFigure {
  int number{};    ///< The paper's figure number; 0: not one of the paper's.
  std::string id;  ///< File-name and anchor safe: "fig-15-hysteresis".
  std::string title;
  std::string caption;      ///< One or two sentences with the key numbers.
  std::string how_to_read;  ///< What to look for, and what a bad one looks like.
  std::string alt;          ///< The picture in words, made from the numbers.
  std::string stage;        ///< Name of the StageReport that it belongs to.
  render::Figure figure;
};

}  // namespace tribolog
