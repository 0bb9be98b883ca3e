#include "figures/sweep/readings.h"

#include <utility>

#include "figures/figure_language.h"
#include "render/composition/publication.h"

namespace tribolog::test {

std::string Reading::name() const {
  return std::string(look == render::figure::Look::report ? "report, " : "publication, ") +
         wording::code_of(language);
}

std::vector<Reading> all_readings() {
  std::vector<Reading> out;
  for (const render::figure::Look look :
       {render::figure::Look::report, render::figure::Look::publication}) {
    for (const wording::Language language : wording::languages()) out.push_back({look, language});
  }
  return out;
}

std::vector<figures::ReportFigure> read_as(const Reading& reading,
                                           const std::vector<figures::ReportFigure>& figures,
                                           const render::text::Font& font) {
  std::vector<figures::ReportFigure> out = figures;
  for (figures::ReportFigure& one : out) {
    one.figure = figures::drawn_in_language(std::move(one.figure), reading.language);
    if (reading.look == render::figure::Look::publication) {
      one.figure = render::composition::for_publication(one.figure, font);
    }
  }
  return out;
}

}  // namespace tribolog::test
