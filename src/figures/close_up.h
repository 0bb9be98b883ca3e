#pragma once
// Ten candidates that nearly coincide: which are drawn, which are only named, and the close-up in
// which the ones that matter are told apart.

#include <string>
#include <vector>

#include "calibration.h"
#include "render/figure.h"

namespace tribolog::figures {

/// One value per run for one estimator, SI or %.
struct NamedValues {
  std::string estimator;
  std::vector<double> values;
  std::vector<std::string> same{};  ///< Further estimators that this curve stands for.
};

/// Mid-line, sweep and pair means first, single points last. Of the former, those that the eye
/// could not tell from one before them at this span of the axis are not drawn again but named with
/// it.
std::vector<NamedValues> in_drawing_order(std::vector<NamedValues> curves, double span);

/// Legend text: "mid-line (79.17 kg) = sweep fit, AB and CD".
std::string legend_words(const Calibration& calibration, const NamedValues& curve);

/// Shows the lower panel's legend only if it says something that the upper one's does not.
void share_legend(const render::Panel& upper, render::Panel& lower);

/// The band in which the curves that matter are told apart.
struct CloseUp {
  double limit{};                    ///< The panel shows -limit to +limit, SI or %.
  std::vector<std::string> outside;  ///< Curves with no value in the band.
};

/// The band holds the paper's choice and the recommended estimator with room for their neighbours.
/// `limit` is 0 if a close-up would show nothing new.
CloseUp close_up(const std::vector<NamedValues>& curves, const SelectionResult& selection);

/// A panel of the curves within the close-up (all of them if its limit is 0), with a zero line.
/// @param si_unit "N·m" or "%"
render::Panel close_up_panel(const Calibration& calibration, const std::vector<NamedValues>& curves,
                             const CloseUp& close, const std::string& quantity,
                             const std::string& si_unit);

}  // namespace tribolog::figures
