#pragma once
// Texts of a scene, each near the point that it names.

#include <string>
#include <vector>

#include "render/figure/draw_list.h"
#include "render/layout/figure_style.h"
#include "render/layout/occupancy.h"

namespace tribolog::render::scene {

struct Caption {
  std::string text;
  figure::PixelPoint anchor;
  figure::Colour colour;
};

/// What texts keep off.
struct Obstacles {
  layout::Occupancy solid;  ///< Parts of the scene.
  layout::Occupancy lines;  ///< Arcs, dimensions and lines.
};

/// Places the captions inside `room`, on as few obstacles as can be, off each other and off each
/// other's leader lines, and draws them with a white halo; one that ends up away from its
/// anchor gets a leader. What still collides, or is cut, is said in the list's warnings.
void draw_captions(figure::DrawList& list, const std::vector<Caption>& captions,
                   const figure::PixelBox& room, const Obstacles& obstacles, const text::Font& font,
                   const layout::FigureStyle& style, text::TextFaults& faults);

}  // namespace tribolog::render::scene
