#include "render/vector/drawn_set.h"

#include <stdexcept>

#include "figures/timeline/comparison_figures.h"
#include "figures/timeline/trend_figures.h"
#include "history/simulated_history.h"
#include "ingest/manifest/robot_file.h"
#include "ingest/manifest/scenario_file.h"
#include "paper/checks/paper_items.h"
#include "render/composition/figure_layout.h"
#include "render/composition/publication.h"
#include "render/example_diagram.h"
#include "render/example_figures.h"
#include "render/png_reading.h"
#include "render/workers/renderer.h"
#include "wording/words.h"

namespace tribolog::render {
namespace {

DrawnExample with_picture(const figures::ReportFigure& figure, const workers::DrawnFigure& picture,
                          const text::Font& font) {
  if (!picture.error.empty()) {
    throw std::runtime_error(picture.id + ": " + wording::words(picture.error));
  }
  return {figure, composition::lay_out(figure.figure, font), read_png(picture.png), {}};
}

}  // namespace

std::vector<figures::ReportFigure> paper_set() {
  const std::string examples = std::string(TRIBOLOG_SOURCE_DIR) + "/examples/paper/";
  const paper::checks::PapersJoint joint(
      ingest::manifest::read_scenario(examples + "scenario.toml"),
      ingest::manifest::read_robot(examples + "am100ib.toml"));
  return paper::checks::paper_figures(joint);
}

std::vector<figures::ReportFigure> history_set(std::size_t most_trends) {
  test::HistoryShape shape;
  shape.calibrations = 24;
  for (std::size_t k = 0; k < shape.calibrations; ++k) {
    shape.temperature_C.push_back(20 + static_cast<double>(k % 7));
  }
  const auto all = test::simulated_history(
      3,
      [](const std::string& name, std::size_t k) {
        return name == "coulomb_torque" && k >= 14 ? 1.08 : 1.0;
      },
      shape);
  std::vector<figures::ReportFigure> out =
      figures::timeline::trend_figures(history::joint_trends(all, {}));
  if (out.size() > most_trends) out.resize(most_trends);
  const auto comparison = history::compare(all[0], all[20], {10, 2}, false);
  for (figures::ReportFigure& one : figures::timeline::comparison_figures(
           comparison, test::simple_curves(0), test::simple_curves(0.1))) {
    out.push_back(std::move(one));
  }
  return out;
}

std::vector<figures::ReportFigure> publication_set() {
  const text::Font font;
  std::vector<figures::ReportFigure> out;
  for (figures::ReportFigure& one : paper_set()) {
    const bool wanted = one.paper_number == 7 || one.paper_number == 10 || one.paper_number == 13 ||
                        one.paper_number == 15 || one.paper_number == 18;
    if (!wanted) continue;
    one.figure = composition::for_publication(one.figure, font);
    out.push_back(std::move(one));
  }
  return out;
}

std::vector<figures::ReportFigure> trouble_set() {
  std::vector<figure::Figure> figures = examples::nasty();
  figures.push_back(examples::diagram());
  figures.push_back(examples::noisy_sweep());
  figures.push_back(examples::many_curves(12));
  std::vector<figures::ReportFigure> out;
  for (figure::Figure& one : figures) {
    figures::ReportFigure figure;
    figure.id = one.id;
    figure.title = one.title;
    figure.figure = std::move(one);
    out.push_back(std::move(figure));
  }
  return out;
}

std::vector<DrawnExample> drawn(const std::vector<figures::ReportFigure>& figures) {
  std::vector<figure::Figure> descriptions;
  std::vector<figure::Figure> scenes;
  for (const figures::ReportFigure& one : figures) {
    descriptions.push_back(one.figure);
    if (one.figure.scene) scenes.push_back(one.figure);
  }
  workers::FigureRenderer renderer(
      2, scenes.empty() ? workers::Prepared::charts : workers::Prepared::charts_and_scenes);
  const auto pictures = renderer.draw(descriptions);
  workers::DrawOptions solid_only;
  solid_only.solid_parts_only = true;
  const auto solid = renderer.draw(scenes, solid_only);
  const text::Font font;
  std::vector<DrawnExample> out;
  std::size_t next_scene = 0;
  for (std::size_t i = 0; i < figures.size(); ++i) {
    out.push_back(with_picture(figures[i], pictures[i], font));
    if (figures[i].figure.scene) out.back().solid_parts = solid[next_scene++].png;
  }
  return out;
}

}  // namespace tribolog::render
