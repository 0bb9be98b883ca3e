#include "figures/figure_set.h"

#include <optional>
#include <utility>

#include "figures/bristle_figures.h"
#include "figures/candidate_figures.h"
#include "figures/cross_check_figures.h"
#include "figures/hysteresis_loops.h"
#include "figures/parameter_figures.h"
#include "figures/selected_curve.h"
#include "figures/sweep_motion.h"
#include "figures/sweep_torque.h"
#include "figures/torque_choice.h"

namespace tribolog::figures {

std::vector<ReportFigure> figure_set(const joint::Dataset& dataset,
                                     const calibration::Calibration& calibration) {
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
  candidates.push_back(curve_model_figure(calibration));
  candidates.push_back(direction_lines_figure(calibration));
  candidates.push_back(load_dependence_figure(calibration));
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

}  // namespace tribolog::figures
