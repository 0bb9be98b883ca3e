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
  wording::Language language{wording::Language::english};
  [[nodiscard]] std::string name() const;
};

/// Both looks in every language.
std::vector<Reading> all_readings();

/// The figures as they are drawn in that look and language.
std::vector<figures::ReportFigure> read_as(const Reading& reading,
                                           const std::vector<figures::ReportFigure>& figures,
                                           const render::text::Font& font);

}  // namespace tribolog::test
