#include "paper/scenes/scene_figures.h"

#include <algorithm>
#include <utility>

#include "paper/scenes/scene_words.h"

namespace tribolog::paper::scenes {
namespace {

std::vector<figures::ReportFigure> drawn_with(const robot::RobotDescription& robot,
                                              const TestNumbers& numbers) {
  std::vector<figures::ReportFigure> figures{robot_figure(robot)};
  for (auto& one : {mass_model_figure(robot, numbers), motion_range_figure(robot, numbers)}) {
    if (one) figures.push_back(*one);
  }
  for (figures::ReportFigure& one : figures) {
    one.figure.id = one.id;
    one.figure.title = drawn_text(one.title, 90);
  }
  return figures;
}

}  // namespace

std::vector<figures::ReportFigure> scene_figures(const robot::RobotDescription& robot) {
  return drawn_with(robot, stated_numbers(robot));
}

std::vector<figures::ReportFigure> scene_figures(const robot::RobotDescription& robot,
                                                 const calibration::Calibration& calibration) {
  return drawn_with(robot, identified_numbers(calibration));
}

std::vector<figures::ReportFigure> with_scene_figures(std::vector<figures::ReportFigure> figures,
                                                      const robot::RobotDescription* robot,
                                                      const calibration::Calibration& calibration) {
  if (robot == nullptr) return figures;
  for (figures::ReportFigure& scene : scene_figures(*robot, calibration)) {
    const auto after =
        std::find_if(figures.begin(), figures.end(),
                     [&](const figures::ReportFigure& one) { return one.number > scene.number; });
    figures.insert(after, std::move(scene));
  }
  return figures;
}

}  // namespace tribolog::paper::scenes
