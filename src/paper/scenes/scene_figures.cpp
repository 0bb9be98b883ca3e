#include "paper/scenes/scene_figures.h"

#include <algorithm>
#include <utility>

#include "paper/scenes/scene_words.h"

namespace tribolog {
namespace {

std::vector<ReportFigure> drawn_with(const RobotDescription& robot,
                                     const scenes::TestNumbers& numbers) {
  std::vector<ReportFigure> figures{robot_figure(robot)};
  for (auto& one : {mass_model_figure(robot, numbers), motion_range_figure(robot, numbers)}) {
    if (one) figures.push_back(*one);
  }
  for (ReportFigure& one : figures) {
    one.figure.id = one.id;
    one.figure.title = scenes::drawn_text(one.title, 90);
  }
  return figures;
}

}  // namespace

std::vector<ReportFigure> scene_figures(const RobotDescription& robot) {
  return drawn_with(robot, scenes::stated_numbers(robot));
}

std::vector<ReportFigure> scene_figures(const RobotDescription& robot,
                                        const Calibration& calibration) {
  return drawn_with(robot, scenes::identified_numbers(calibration));
}

std::vector<ReportFigure> with_scene_figures(std::vector<ReportFigure> figures,
                                             const RobotDescription* robot,
                                             const Calibration& calibration) {
  if (robot == nullptr) return figures;
  for (ReportFigure& scene : scene_figures(*robot, calibration)) {
    const auto after = std::find_if(figures.begin(), figures.end(), [&](const ReportFigure& one) {
      return one.number > scene.number;
    });
    figures.insert(after, std::move(scene));
  }
  return figures;
}

}  // namespace tribolog
