#include "figures/sweep/readings.h"

#include "render/composition/publication.h"

namespace tribolog::test {

std::string Reading::name() const {
  return std::string(look == render::figure::Look::report ? "report, " : "publication, ") +
         language.code;
}

std::vector<Reading> all_readings() {
  std::vector<Reading> out;
  for (const render::figure::Look look :
       {render::figure::Look::report, render::figure::Look::publication}) {
    for (const wording::Language& language : wording::languages()) out.push_back({look, language});
  }
  return out;
}

figures::ReportFigure read_as(const Reading& reading, figures::ReportFigure figure,
                              const render::text::Font& font) {
  if (reading.look == render::figure::Look::publication) {
    figure.figure = render::composition::for_publication(figure.figure, font);
  }
  return figure;
}

}  // namespace tribolog::test
