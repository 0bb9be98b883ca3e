#pragma once
// Ten candidates that nearly coincide: which are drawn, which are only named, and the close-up in
// which the ones that matter are told apart.

#include <string>
#include <vector>

#include "calibration/calibration.h"
#include "render/figure/figure.h"

namespace tribolog::figures {

/// One value per run for one estimator, SI or %.
struct NamedValues {
  method::hysteresis::Estimator estimator{};
  std::vector<double> values;
  std::vector<std::string> same{};  ///< Further estimators that this curve stands for.
};

/// Mid-line, sweep and pair means first, single points last. Of the former, those that the eye
/// could not tell from one before them at this span of the axis are not drawn again but named with
/// it.
std::vector<NamedValues> in_drawing_order(std::vector<NamedValues> curves, double span);

/// Legend text: "mid-line (79.17 kg) = sweep fit, AB and CD".
std::string legend_words(const calibration::Calibration& calibration, const NamedValues& curve);

/// Shows the lower panel's legend only if it says something that the upper one's does not.
void share_legend(const render::figure::Panel& upper, render::figure::Panel& lower);

/// Half the height of the band in which the curves that matter are told apart, SI or %: it holds
/// the paper's choice and the recommended estimator with room for their neighbours. 0 if a close-up
/// would show nothing new.
double close_up_limit(const std::vector<NamedValues>& curves,
                      const method::selection::SelectionResult& selection);

/// A panel of the curves within -limit to +limit (all of them if it is 0), with a zero line. A
/// curve without a value in there is left out and named in the title; if it is so on one side of
/// standstill only, that side is.
/// @param si_unit "N·m" or "%"
render::figure::Panel close_up_panel(const calibration::Calibration& calibration,
                                     std::vector<NamedValues> curves, double limit,
                                     const std::string& quantity, const std::string& si_unit);

}  // namespace tribolog::figures
