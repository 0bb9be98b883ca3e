#pragma once
// Whether a finished picture shows the solid parts of its scene.

#include "render/check/picture_check.h"
#include "render/figure/draw_list.h"
#include "render/figure/picture.h"

namespace tribolog::render::check {

/// Adds an error about the first part with a label that the picture does not show where it must,
/// and a warning about each that is hidden by others. Light and shade change how bright a part is,
/// not its hue.
/// @pre the list has a scene
void check_parts(const figure::DrawList& list, const figure::Picture& picture,
                 PictureFindings& findings);

}  // namespace tribolog::render::check
