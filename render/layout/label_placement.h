#pragma once
// Texts beside points and at reference lines, where they hide as little as possible.

#include <vector>

#include "render/figure/draw_list.h"
#include "render/layout/discrete_marks.h"
#include "render/layout/figure_style.h"
#include "render/layout/occupancy.h"
#include "render/layout/panel_frame.h"

namespace tribolog::render {

/// Places the texts of a panel's reference lines, then its point labels, and marks both in
/// `taken`. Point labels avoid each other, each other's points, the data and the panel's border;
/// one that ends up away from its point gets a leader line. Neither hides one of `marks` where
/// there is any other place; the texts of reference lines become marks for the labels.
void draw_reference_texts(DrawList& list, const PanelFrame& frame, const Panel& panel,
                          const Font& font, const FigureStyle& style, int index, Occupancy& taken,
                          DiscreteMarks& marks, TextFaults& faults);
void draw_point_labels(DrawList& list, const PanelFrame& frame, const Panel& panel,
                       const Font& font, const FigureStyle& style, int index, Occupancy& taken,
                       const DiscreteMarks& marks, TextFaults& faults);

}  // namespace tribolog::render
