#pragma once
// Texts and lines that are too faint.

#include "render/figure/draw_list.h"
#include "render/legibility/finding.h"

namespace tribolog::render::legibility {

/// A colour laid on an opaque one.
figure::Colour laid_on(figure::Colour ground, figure::Colour colour);

/// Texts with less than 4.5 : 1 against what is filled below them, where it is worst.
Findings faint_texts(const figure::DrawList& list);

/// Curves, markers, intervals and lines of drawings with less than 3 : 1 against white paper, each
/// once. Excused are:
/// - orange, sky blue and yellow of Okabe and Ito's palette: chosen to be told from each other with
///   every colour blindness, they are light. Such a line must have dashes, a marker, or at least
///   the usual width;
/// - what lies pale below a curve of the same panel that is not: samples under their fit.
Findings faint_lines(const figure::DrawList& list);

}  // namespace tribolog::render::legibility
