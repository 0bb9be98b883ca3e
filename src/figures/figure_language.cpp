#include "figures/figure_language.h"

#include <utility>

namespace tribolog::figures {
namespace {

class DrawnTexts {
 public:
  explicit DrawnTexts(const wording::Catalogue& catalogue) : catalogue_(catalogue) {}

  void translate(render::figure::Figure& figure) const {
    change(figure.title);
    for (render::figure::Panel& panel : figure.panels) translate(panel);
    if (figure.diagram) translate(*figure.diagram);
    if (figure.scene) translate(*figure.scene);
  }

 private:
  void change(std::string& text) const {
    if (!text.empty()) text = catalogue_.translate(text);
  }

  void translate(render::figure::Panel& panel) const {
    change(panel.title);
    change(panel.notice);
    for (render::figure::Axis* axis : {&panel.x, &panel.y}) {
      change(axis->title);
      for (render::figure::AxisName& name : axis->names) change(name.text);
    }
    for (render::figure::Band& band : panel.bands) change(band.label);
    for (render::figure::Series& series : panel.series) change(series.label);
    for (render::figure::PointLabel& label : panel.point_labels) change(label.text);
    for (render::figure::ReferenceLine& line : panel.reference_lines) change(line.text);
  }

  void translate(render::figure::Diagram& diagram) const {
    for (render::figure::Block& block : diagram.blocks) {
      for (std::string& line : block.lines) change(line);
    }
    for (render::figure::Wire& wire : diagram.wires) {
      if (wire.label) change(wire.label->text);
    }
    for (render::figure::Dimension& dimension : diagram.dimensions) change(dimension.text);
    for (render::figure::DiagramText& text : diagram.texts) change(text.text);
  }

  template <typename Parts>
  void change_labels(Parts& parts) const {
    for (auto& part : parts) change(part.label);
  }

  void translate(render::figure::Scene& scene) const {
    change_labels(scene.bodies);
    change_labels(scene.drums);
    change_labels(scene.arrows);
    change_labels(scene.balls);
    change_labels(scene.sectors);
    change_labels(scene.dimensions);
    change_labels(scene.lines);
    for (render::figure::SceneText& text : scene.texts) change(text.text);
  }

  const wording::Catalogue& catalogue_;
};

}  // namespace

render::figure::Figure drawn_in_language(render::figure::Figure figure,
                                         wording::Language language) {
  const wording::Catalogue* const catalogue = wording::catalogue_of(language);
  if (catalogue != nullptr) DrawnTexts(*catalogue).translate(figure);
  return figure;
}

ReportFigure as_file_in_language(ReportFigure figure, wording::Language language) {
  figure.figure = drawn_in_language(std::move(figure.figure), language);
  figure.title = wording::in_language(language, figure.title);
  figure.alt = wording::in_language(language, figure.alt);
  return figure;
}

}  // namespace tribolog::figures
