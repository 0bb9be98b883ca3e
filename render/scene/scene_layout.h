#pragma once
// From the description of a scene to its draw list. Needs no graphics.

#include "render/figure/draw_list.h"
#include "render/figure/figure.h"
#include "render/layout/figure_style.h"
#include "render/text/font.h"

namespace tribolog::render::scene {

/// @pre the figure has a scene.
/// @throw tribolog::FigureError for a camera or a scene that cannot be shown (see fit_view()), or a
/// part that has no direction.
figure::DrawList lay_out_scene(const figure::Figure& figure, const text::Font& font,
                               text::TextFaults& faults);

}  // namespace tribolog::render::scene
