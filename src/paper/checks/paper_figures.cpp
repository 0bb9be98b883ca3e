#include "paper/checks/paper_figures.h"

#include <algorithm>
#include <iterator>

#include "figures/figure_set.h"
#include "paper/charts/presliding_figure.h"
#include "paper/charts/static_law_figures.h"
#include "paper/drawings/paper_drawings.h"
#include "paper/scenes/scene_figures.h"

namespace tribolog::paper::checks {

std::vector<figures::ReportFigure> paper_figures(const PapersJoint& joint) {
  std::vector<figures::ReportFigure> figures{charts::static_friction_figure(joint.discontinuous),
                                             charts::linear_zone_figure(joint.continuous),
                                             charts::presliding_hysteresis_figure(joint.loops)};
  const auto add = [&](std::vector<figures::ReportFigure> more) {
    std::move(more.begin(), more.end(), std::back_inserter(figures));
  };
  add(drawings::paper_drawings(joint.scenario.gear_ratio));
  add(scenes::scene_figures(joint.robot));
  add(figures::figure_set(joint.dataset, joint.calibration));
  std::sort(figures.begin(), figures.end(),
            [](const figures::ReportFigure& a, const figures::ReportFigure& b) {
              return a.number < b.number;
            });
  return figures;
}

}  // namespace tribolog::paper::checks
