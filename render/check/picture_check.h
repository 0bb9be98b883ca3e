#pragma once
// Whether a finished picture shows what its draw list says. The graphics stack can fail silently:
// a wrong OpenGL library gives a white picture and reports success.

#include <vector>

#include "base/statement.h"
#include "render/figure/draw_list.h"
#include "render/figure/picture.h"

namespace tribolog::render::check {

struct PictureFindings {
  Statement error;  ///< Empty if the picture is whole.
  std::vector<Statement> warnings;
};

/// An error: a blank picture, a series or band (in a diagram a block or wire, in a scene a part
/// with a label) that is not visible where it must be, one in the colour of the background, a text
/// without ink. A warning: a series that lies wholly outside its axes or under what is painted
/// later, or a part behind others, and so cannot be seen by anyone's fault but its own.
PictureFindings check_picture(const figure::DrawList& list, const figure::Figure& figure,
                              const figure::Picture& picture);

}  // namespace tribolog::render::check
