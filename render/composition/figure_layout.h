#pragma once
// From the description of a figure to its draw list. Needs no graphics.

#include "render/figure/draw_list.h"
#include "render/figure/figure.h"
#include "render/text/font.h"

namespace tribolog::render::composition {

/// Lays a figure out. Never fails for what a panel's data is like: what cannot be shown is left out
/// and reported in `warnings`; a panel without anything to show says so (Panel::notice).
/// @throw tribolog::FigureError if the picture's size is not between 64 and 16384 pixels, if a
/// figure has both panels and a scene, or if the scene cannot be shown.
figure::DrawList lay_out(const figure::Figure& figure, const text::Font& font);

}  // namespace tribolog::render::composition
