#pragma once
// The ways in which a figure meets its reader.

#include <string>
#include <vector>

#include "figures/report_figure.h"
#include "render/text/font.h"
#include "wording/language.h"

namespace tribolog::test {

/// A look in a language: "report, en".
struct Reading {
  render::figure::Look look{render::figure::Look::report};
  wording::Language language;
  [[nodiscard]] std::string name() const;
};

/// Both looks in every language.
std::vector<Reading> all_readings();

/// The figure as it is drawn in that look.
figures::ReportFigure read_as(const Reading& reading, figures::ReportFigure figure,
                              const render::text::Font& font);

}  // namespace tribolog::test
