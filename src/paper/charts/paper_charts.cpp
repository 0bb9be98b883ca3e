#include "paper/charts/paper_charts.h"

#include "paper/charts/joint_scale.h"
#include "paper/charts/linear_zone_figure.h"
#include "paper/charts/presliding_figure.h"
#include "paper/charts/static_friction_figure.h"

namespace tribolog::paper {

std::vector<ReportFigure> paper_charts() {
  return {static_friction_figure(stribeck_at_joint_scale()),
          linear_zone_figure(linear_zone_at_joint_scale()),
          presliding_hysteresis_figure(presliding_loops({}))};
}

}  // namespace tribolog::paper
