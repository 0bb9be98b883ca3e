#include "figures/figure_language.h"

#include <utility>

namespace tribolog {
namespace {

class DrawnTexts {
 public:
  explicit DrawnTexts(const Catalogue& catalogue) : catalogue_(catalogue) {}

  void translate(render::Figure& figure) const {
    change(figure.title);
    for (render::Panel& panel : figure.panels) translate(panel);
    if (figure.diagram) translate(*figure.diagram);
    if (figure.scene) translate(*figure.scene);
  }

 private:
  void change(std::string& text) const {
    if (!text.empty()) text = catalogue_.translate(text);
  }

  void translate(render::Panel& panel) const {
    change(panel.title);
    change(panel.notice);
    for (render::Axis* axis : {&panel.x, &panel.y}) {
      change(axis->title);
      for (render::AxisName& name : axis->names) change(name.text);
    }
    for (render::Band& band : panel.bands) change(band.label);
    for (render::Series& series : panel.series) change(series.label);
    for (render::PointLabel& label : panel.point_labels) change(label.text);
    for (render::ReferenceLine& line : panel.reference_lines) change(line.text);
  }

  void translate(render::Diagram& diagram) const {
    for (render::Block& block : diagram.blocks) {
      for (std::string& line : block.lines) change(line);
    }
    for (render::Wire& wire : diagram.wires) {
      if (wire.label) change(wire.label->text);
    }
    for (render::Dimension& dimension : diagram.dimensions) change(dimension.text);
    for (render::DiagramText& text : diagram.texts) change(text.text);
  }

  template <typename Parts>
  void change_labels(Parts& parts) const {
    for (auto& part : parts) change(part.label);
  }

  void translate(render::Scene& scene) const {
    change_labels(scene.bodies);
    change_labels(scene.drums);
    change_labels(scene.arrows);
    change_labels(scene.balls);
    change_labels(scene.sectors);
    change_labels(scene.dimensions);
    change_labels(scene.lines);
    for (render::SceneText& text : scene.texts) change(text.text);
  }

  const Catalogue& catalogue_;
};

}  // namespace

render::Figure drawn_in_language(render::Figure figure, Language language) {
  const Catalogue* const catalogue = catalogue_of(language);
  if (catalogue != nullptr) DrawnTexts(*catalogue).translate(figure);
  return figure;
}

ReportFigure as_file_in_language(ReportFigure figure, Language language) {
  figure.figure = drawn_in_language(std::move(figure.figure), language);
  figure.title = in_language(language, figure.title);
  figure.alt = in_language(language, figure.alt);
  return figure;
}

}  // namespace tribolog
