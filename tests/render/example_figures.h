#pragma once
// Figures like those of a report, and nasty ones.

#include <vector>

#include "render/figure/figure.h"

namespace tribolog::render::examples {

Series line(std::vector<double> x, std::vector<double> y, const char* label = "line");

/// One panel with one series.
Figure plain();
/// A loop with a mid-line, arrows and six points, three of them close together.
Figure hysteresis();
/// Three panels over time.
Figure stacked();
/// Ten to twelve curves with markers that leave no corner free.
Figure many_curves(int count);
/// 70,000 noisy samples, fit, band, marked maximum, reference lines, error bars.
Figure noisy_sweep();

/// One of each kind of part, with a label where it can have one; in perspective or parallel.
Figure scene(double opening_deg = 0);

/// Every kind of trouble, each a figure of its own.
std::vector<Figure> nasty();

}  // namespace tribolog::render::examples
