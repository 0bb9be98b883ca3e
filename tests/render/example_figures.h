#pragma once
// Figures like those of a report, and nasty ones.

#include <vector>

#include "render/figure/figure.h"

namespace tribolog::render::examples {

figure::Series line(std::vector<double> x, std::vector<double> y, const char* label = "line");

/// One panel with one series.
figure::Figure plain();
/// A loop with a mid-line, arrows and six points, three of them close together.
figure::Figure hysteresis();
/// Three panels over time.
figure::Figure stacked();
/// Ten to twelve curves with markers that leave no corner free.
figure::Figure many_curves(int count);
/// 70,000 noisy samples, fit, band, marked maximum, reference lines, error bars.
figure::Figure noisy_sweep();

/// One of each kind of part, with a label where it can have one; in perspective or parallel.
figure::Figure scene(double opening_deg = 0);

/// Every kind of trouble, each a figure of its own.
std::vector<figure::Figure> nasty();

}  // namespace tribolog::render::examples
