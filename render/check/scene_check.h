#pragma once
// Whether a finished picture shows the solid parts of its scene.

#include <string>

#include "render/draw_list.h"
#include "render/paint/picture.h"

namespace tribolog::render {

/// One sentence about the first part with a label that is hidden by others, or that the picture
/// does not show where it must; empty if there is none. Light and shade change how bright a part
/// is, not its hue.
/// @pre the list has a scene
std::string missing_part(const DrawList& list, const Picture& picture);

}  // namespace tribolog::render
