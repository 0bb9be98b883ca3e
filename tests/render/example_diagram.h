#pragma once
// A drawing with one of each kind of part, and no fault.

#include <utility>

#include "render/figure/figure.h"

namespace tribolog::render::examples {

inline figure::Figure diagram() {
  figure::Figure figure;
  figure.id = "diagram";
  figure.title = "One of each kind";
  figure.height_px = 900;
  figure::Diagram& drawing = figure.diagram.emplace();
  drawing.height = 80;
  const auto block = [](figure::BlockKind kind, std::vector<std::string> lines,
                        figure::DiagramPoint centre, double width, double height) {
    figure::Block one;
    one.kind = kind;
    one.lines = std::move(lines);
    one.centre = centre;
    one.width = width;
    one.height = height;
    return one;
  };
  drawing.blocks = {block(figure::BlockKind::terminal, {"ω"}, {10, 20}, 12, 10),
                    block(figure::BlockKind::summing_junction, {}, {35, 20}, 10, 10),
                    block(figure::BlockKind::integrator, {}, {60, 20}, 14, 13),
                    block(figure::BlockKind::gain, {"σ_{0}"}, {90, 20}, 15, 14),
                    block(figure::BlockKind::selector, {}, {115, 24}, 12, 16),
                    block(figure::BlockKind::plain, {"two", "lines"}, {90, 45}, 20, 14),
                    block(figure::BlockKind::frame, {"frame"}, {90, 44}, 36, 26),
                    block(figure::BlockKind::fixed_support, {}, {30, 70}, 40, 4)};
  drawing.blocks[1].signs = {{figure::BlockSide::left, 0, "+"},
                             {figure::BlockSide::bottom, 0, "−"}};
  drawing.blocks[7].faces = figure::BlockSide::top;
  const auto wire = [](std::vector<figure::DiagramPoint> points) {
    figure::Wire one;
    one.points = std::move(points);
    return one;
  };
  drawing.wires = {wire({{16, 20}, {30, 20}}), wire({{40, 20}, {53, 20}}),
                   wire({{67, 20}, {82.5, 20}}), wire({{97.5, 20}, {109, 20}}),
                   wire({{68.5, 20}, {68.5, 40}, {35, 40}, {35, 25}})};
  drawing.wires[1].label = figure::DiagramText{"dz/dt", {46, 20}, figure::TextPlace::above};
  drawing.wires[4].branch_dots = {{68.5, 20}};
  drawing.areas = {{{{10, 55}, {50, 55}, {50, 68}, {10, 68}}, {226, 240, 250}}};
  figure::Stroke stroke;
  stroke.points = {{60, 60}, {60, 75}};
  stroke.arrow_at_end = true;
  drawing.strokes = {stroke};
  figure::Arc arc;
  arc.centre = {130, 60};
  arc.radius = 10;
  arc.to_deg = 240;
  arc.arrow_at_end = true;
  drawing.arcs = {arc};
  drawing.dimensions = {{{70, 70}, {110, 70}, "z", figure::TextPlace::above}};
  drawing.texts = {{"free text", {140, 75}, figure::TextPlace::centre}};
  return figure;
}

}  // namespace tribolog::render::examples
