#include "paper/scenes/scene_figures.h"

namespace tribolog {

std::vector<ReportFigure> scene_figures(const RobotDescription& robot) {
  std::vector<ReportFigure> figures{robot_figure(robot), mass_model_figure(robot),
                                    motion_range_figure(robot)};
  for (ReportFigure& one : figures) {
    one.figure.id = one.id;
    one.figure.title = one.title;
  }
  return figures;
}

}  // namespace tribolog
