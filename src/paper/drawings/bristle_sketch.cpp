#include <utility>

#include "paper/drawings/paper_drawings.h"
#include "paper/drawings/schematic.h"
#include "wording/tr.h"

namespace tribolog::paper::drawings {

std::vector<render::figure::DiagramPoint> bent_bristle(render::figure::DiagramPoint root,
                                                       double length, double deflection) {
  constexpr int steps = 24;
  std::vector<render::figure::DiagramPoint> points;
  for (int i = 0; i <= steps; ++i) {
    const double s = static_cast<double>(i) / steps;
    points.push_back({root.x + deflection * s * s * (3.0 - s) / 2.0, root.y + length * s});
  }
  return points;
}

std::vector<render::figure::DiagramPoint> upright_rectangle(double left, double top, double right,
                                                            double bottom) {
  return {{left, top}, {right, top}, {right, bottom}, {left, bottom}};
}

namespace {

using render::figure::Diagram;
using render::figure::DiagramPoint;
using render::figure::LineStyle;
using render::figure::TextPlace;
using wording::tr;

constexpr double upper_top = 14;
constexpr double upper_surface = 28;
constexpr double lower_surface = 57;
constexpr double lower_bottom = 70;
constexpr double bristle_length = 18;
constexpr double mean_deflection = 7;
constexpr double bristle_px = 4.0;
constexpr render::figure::Colour rigid = render::figure::palette::vermilion;
constexpr render::figure::Colour rest = render::figure::palette::grey;

void add_line(render::figure::Diagram& diagram, std::vector<render::figure::DiagramPoint> points,
              render::figure::Colour colour, double width_px = 2.5,
              render::figure::LineStyle style = render::figure::LineStyle::solid) {
  render::figure::Stroke stroke;
  stroke.points = std::move(points);
  stroke.colour = colour;
  stroke.width_px = width_px;
  stroke.style = style;
  diagram.strokes.push_back(std::move(stroke));
}

/// A body with a surface; its other three sides are not outlined where it goes on.
void add_body(render::figure::Diagram& diagram, double left, double top, double right,
              double bottom, double surface, render::figure::Colour colour) {
  diagram.areas.push_back({upright_rectangle(left, top, right, bottom), colour});
  add_line(diagram, {{left, surface}, {right, surface}}, render::figure::palette::black, 3.0);
}

void add_contact(render::figure::Diagram& diagram) {
  add_body(diagram, 6, upper_top, 98, upper_surface, upper_surface, ground::element);
  add_body(diagram, 6, lower_surface, 98, lower_bottom, lower_surface, ground::outside);
  render::figure::Block support;
  support.kind = render::figure::BlockKind::fixed_support;
  support.centre = {52, lower_bottom + 2};
  support.width = 92;
  support.height = 4;
  support.faces = render::figure::BlockSide::top;
  diagram.blocks.push_back(support);
  // Bristles differ; z is the mean of what they deflect.
  const double deflections[] = {6.2, 7.6, 6.6, 8.1, 6.5};
  double root = 23;
  for (const double deflection : deflections) {
    const auto bristle = bent_bristle({root, upper_surface}, bristle_length, -deflection);
    const render::figure::DiagramPoint touched = bristle[20];
    add_line(diagram, bristle, bristle_colour, bristle_px);
    const double beside = 0.5;
    add_line(diagram, {{touched.x + beside, touched.y}, {touched.x + beside, lower_surface}}, rigid,
             bristle_px);
    root += 16;
  }
  diagram.texts.push_back({tr("moving body (motor shaft)"),
                           {52, (upper_top + upper_surface) / 2},
                           render::figure::TextPlace::centre});
  diagram.texts.push_back({tr("body at rest (housing)"),
                           {52, (lower_surface + lower_bottom) / 2},
                           render::figure::TextPlace::centre});
  render::figure::Stroke motion;
  motion.points = {{40, 8.5}, {64, 8.5}};
  motion.width_px = 4.0;
  motion.arrow_at_end = true;
  diagram.strokes.push_back(motion);
  diagram.texts.push_back({tr("speed ω"), {52, 8}, render::figure::TextPlace::above});
}

void add_mean_bristle(render::figure::Diagram& diagram) {
  const double left = 110;
  const double right = 154;
  const double root = 146;
  const double length = 24;
  const double tip_level = upper_surface + length;
  const double tip = root - enlargement_of_mean_bristle * mean_deflection;
  add_body(diagram, left, upper_top, right, upper_surface, upper_surface, ground::element);
  diagram.texts.push_back({tr("the mean bristle"),
                           {(left + right) / 2, (upper_top + upper_surface) / 2},
                           render::figure::TextPlace::centre});
  add_line(diagram, {{root, upper_surface}, {root, tip_level + 7}}, rest, 2.0,
           render::figure::LineStyle::dash);
  add_line(diagram, {{tip, tip_level}, {tip, tip_level + 7}}, rest, 2.0,
           render::figure::LineStyle::dash);
  add_line(diagram, bent_bristle({root, upper_surface}, length, tip - root), bristle_colour,
           bristle_px);
  render::figure::Dimension z;
  z.from = {tip, tip_level + 5};
  z.to = {root, tip_level + 5};
  z.text = "z";
  z.place = render::figure::TextPlace::below;
  diagram.dimensions.push_back(z);
  render::figure::Stroke force;
  force.points = {{tip - 0.5, tip_level}, {tip - 21, tip_level}};
  force.arrow_at_end = true;
  force.width_px = 3.5;
  force.colour = rigid;
  diagram.strokes.push_back(force);
  diagram.texts.push_back(
      {"σ_{0} z + σ_{1} dz/dt", {tip - 11, tip_level - 1}, render::figure::TextPlace::above});
}

}  // namespace

figures::ReportFigure bristle_sketch_figure() {
  figures::ReportFigure out;
  out.paper_number = 3;
  out.id = "fig-03-bristles";
  out.title = tr("Surfaces in contact through elastic bristles");
  out.caption = tr(
      "The picture behind LuGre: asperities of the moving surface bend like bristles when those of "
      "the other hold them back. z is their mean deflection; bending gives the friction torque "
      "σ₀ z + σ₁ dz/dt.");
  out.how_to_read = tr(
      "Blue: bristles of the moving surface, elastic. Red: those of the surface at rest, drawn "
      "rigid for simplicity. At rest a blue bristle hangs along the dashed line; once it is bent "
      "far enough it slips off, so that z does not exceed g(ω) in steady sliding.");
  out.alt =
      tr("Sketch. A body moves to the right over a body at rest. Elastic bristles under the moving "
         "body are bent to the left by rigid ones of the other. An enlarged bristle shows the mean "
         "deflection z between its tip and its place at rest.");
  render::figure::Diagram& diagram = out.figure.diagram.emplace();
  diagram.height = 77;
  add_contact(diagram);
  add_mean_bristle(diagram);
  out.figure.height_px = 850;
  out.figure.id = out.id;
  out.figure.title = out.title;
  return out;
}

}  // namespace tribolog::paper::drawings
