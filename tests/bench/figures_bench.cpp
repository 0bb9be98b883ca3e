// 22 figures: the eleven of the paper's joint, twice, from the recordings to PNG bytes. A peer's
// program does the same (peer/draw_22.py); compare.py times both as whole processes.

#include <cstdio>

#include "figures/figure_set.h"
#include "identify/identify.h"
#include "render/workers/renderer.h"
#include "support/paper_joint.h"
#include "wording/words.h"

int main() {
  using namespace tribolog;
  tribolog::render::workers::FigureRenderer renderer;
  const tribolog::joint::Dataset dataset =
      tribolog::simulate::simulated_dataset(tribolog::test::paper_joint());
  const tribolog::calibration::Calibration calibration = tribolog::identify::identify(dataset);
  std::vector<tribolog::render::figure::Figure> figures;
  for (int round = 0; round < 2; ++round) {
    for (const tribolog::figures::ReportFigure& f :
         tribolog::figures::figure_set(dataset, calibration)) {
      // The paper's bear its numbers; the peer knows no others.
      if (!f.figure.id.starts_with("fig-1") && !f.figure.id.starts_with("fig-2")) continue;
      figures.push_back(f.figure);
      figures.back().id += round == 0 ? "-a" : "-b";
    }
  }
  std::size_t bytes = 0;
  for (const tribolog::render::workers::DrawnFigure& drawn : renderer.draw(figures)) {
    if (!drawn.error.empty()) {
      std::fprintf(stderr, "%s: %s\n", drawn.id.c_str(),
                   tribolog::wording::words(drawn.error).c_str());
      return 1;
    }
    bytes += drawn.png.size();
  }
  std::printf("%zu figures, %zu bytes\n", figures.size(), bytes);
  return figures.size() == 22 ? 0 : 1;
}
