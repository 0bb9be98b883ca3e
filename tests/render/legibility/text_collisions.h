#pragma once
// Texts over each other, over data, and over the edge.

#include "render/figure/draw_list.h"
#include "render/legibility/finding.h"

namespace tribolog::render::legibility {

/// Two texts of different owners whose boxes share more than a pixel.
Findings overlapping_texts(const figure::DrawList& list);

/// Texts that reach beyond the picture.
Findings texts_off_the_picture(const figure::DrawList& list);

/// Texts with data under them and no backing between, or with data painted over them. Data are
/// curves, markers, intervals, arrows of direction, points with a name, leaders and reference
/// lines; in drawings wires, shapes and lines.
Findings texts_on_data(const figure::DrawList& list);

/// Markers and intervals, few enough to be looked at one by one, that the text before them or its
/// backing hides. Of a cloud of markers no single one matters.
Findings markers_under_texts(const figure::DrawList& list);

/// Curves that a label or the text of a reference line hides, also where it has a backing: a label
/// can stand farther from its point, with a leader.
Findings curves_under_labels(const figure::DrawList& list);

/// Data under a legend.
Findings data_under_legends(const figure::DrawList& list);

}  // namespace tribolog::render::legibility
