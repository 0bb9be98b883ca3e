#include "figures/figure_set.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "figures/bristle_figures.h"
#include "figures/candidate_figures.h"
#include "figures/cross_check_figures.h"
#include "figures/hysteresis_loops.h"
#include "figures/selected_curve.h"
#include "figures/sweep_motion.h"
#include "figures/sweep_torque.h"
#include "figures/torque_choice.h"
#include "wording/torques_in.h"

namespace tribolog::figures {

std::vector<ReportFigure> figure_set(const joint::Dataset& dataset,
                                     const calibration::Calibration& calibration) {
  const wording::TorquesIn unit(calibration.manifest.torque_unit());
  std::vector<std::optional<ReportFigure>> candidates;
  candidates.push_back(sweep_motion_figure(dataset, calibration));
  candidates.push_back(rough_torque_figure(dataset, calibration));
  candidates.push_back(precise_torque_figure(dataset, calibration));
  candidates.push_back(torque_loop_figure(calibration));
  candidates.push_back(bristle_loop_figure(calibration));
  candidates.push_back(bristle_rate_loop_figure(calibration));
  candidates.push_back(friction_candidates_figure(calibration));
  candidates.push_back(friction_curves_figure(calibration));
  candidates.push_back(friction_against_reference_figure(calibration));
  candidates.push_back(quality_error_figure(calibration));
  candidates.push_back(selected_curve_figure(calibration));
  candidates.push_back(torque_choice_figure(calibration));
  candidates.push_back(lugre_loop_figure(calibration));
  candidates.push_back(break_away_figure(dataset, calibration));
  candidates.push_back(mass_comparison_figure(calibration));
  candidates.push_back(truth_check_figure(calibration));

  std::vector<ReportFigure> figures;
  for (auto& candidate : candidates) {
    if (!candidate) continue;
    candidate->figure.id = candidate->id;
    candidate->figure.title = candidate->title;
    figures.push_back(std::move(*candidate));
  }
  return figures;
}

std::vector<ReportFigure> for_a_report(std::vector<ReportFigure> figures) {
  constexpr std::pair<std::string_view, std::string_view> combined[] = {
      {"fig-18-friction-curves", "fig-friction-candidates"},
      {"fig-19-friction-against-reference", "fig-friction-candidates"},
      {"fig-20-quality-error", "fig-friction-candidates"},
      {"fig-09-robot", "fig-10-phenomenological-model"}};
  std::set<std::string, std::less<>> there;
  for (const ReportFigure& one : figures) there.insert(one.id);
  std::erase_if(figures, [&](const ReportFigure& one) {
    return std::any_of(std::begin(combined), std::end(combined), [&](const auto& pair) {
      return pair.first == one.id && there.contains(pair.second);
    });
  });
  constexpr double share_in_sight = 0.875;  // 1400 px, 220 to the inch
  constexpr double folded_share = 0.55;
  for (ReportFigure& one : figures) {
    one.figure.title.clear();
    const double share = one.is_primary ? share_in_sight : folded_share;
    one.figure.width_px = static_cast<int>(std::lround(share * one.figure.width_px));
    one.figure.height_px = static_cast<int>(std::lround(share * one.figure.height_px));
  }
  return figures;
}

}  // namespace tribolog::figures
