#include "figures/sweep/readings.h"

#include <utility>

#include "figures/figure_language.h"
#include "render/composition/publication.h"

namespace tribolog::test {

std::string Reading::name() const {
  return std::string(look == render::Look::report ? "report, " : "publication, ") +
         code_of(language);
}

std::vector<Reading> all_readings() {
  std::vector<Reading> out;
  for (const render::Look look : {render::Look::report, render::Look::publication}) {
    for (const Language language : languages()) out.push_back({look, language});
  }
  return out;
}

std::vector<ReportFigure> read_as(const Reading& reading, const std::vector<ReportFigure>& figures,
                                  const render::Font& font) {
  std::vector<ReportFigure> out = figures;
  for (ReportFigure& one : out) {
    one.figure = drawn_in_language(std::move(one.figure), reading.language);
    if (reading.look == render::Look::publication) {
      one.figure = render::for_publication(one.figure, font);
    }
  }
  return out;
}

}  // namespace tribolog::test
