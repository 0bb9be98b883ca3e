#include "figures/quality_error.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "figures/close_up.h"
#include "figures/estimator_style.h"
#include "figures/run_curves.h"
#include "wording/number_text.h"
#include "wording/shaft.h"

namespace tribolog::figures {
namespace {

std::string rms_words(const QualityErrorsResult& quality, const std::string& estimator) {
  const QualityError* error = quality.find(estimator);
  if (error == nullptr) return {};
  return fmt::format("{} {}", estimator_words(estimator),
                     size_words(error->rms_percent, percent_floor, "%"));
}

/// How well the reference itself is known, as a bar about zero at each run.
void add_interval_of_reference(render::Panel& panel, const Calibration& calibration) {
  const QualityErrorsResult& quality = calibration.quality;
  if (!(quality.reference_rms_percent > 0.0)) return;
  const std::vector<double>& errors = quality.errors.front().percent;
  const std::size_t size = std::min(
      {quality.reference_half_width_Nm.size(), calibration.viscous.runs.size(), errors.size()});
  for (std::size_t i = 0; i < size; ++i) {
    const ConstantSpeedRun& run = calibration.viscous.runs[i];
    const double percent = std::abs(100 * quality.reference_half_width_Nm[i] / run.torque_Nm);
    if (!std::isfinite(errors[i] + percent)) continue;
    panel.error_bars.push_back({run.speed_rad_s, -percent, percent, render::palette::grey});
  }
}

}  // namespace

std::optional<ReportFigure> quality_error_figure(const Calibration& calibration) {
  const QualityErrorsResult& quality = calibration.quality;
  if (quality.reference.empty() || quality.errors.empty()) return std::nullopt;
  std::vector<NamedValues> errors;
  for (const QualityError& error : quality.errors) {
    errors.push_back({error.estimator, error.percent});
  }

  ReportFigure out;
  out.number = 20;
  out.id = "fig-20-quality-error";
  out.title = "Error in % of the driving torque";
  out.stage = "quality_errors";
  const std::string symbol = "error 100 (T_{f} − T_{f,ref}) / T";
  render::Panel all = close_up_panel(calibration, errors, 0.0, symbol, "%");
  if (all.series.empty()) return std::nullopt;
  add_interval_of_reference(all, calibration);
  out.figure.panels.push_back(std::move(all));
  const double limit = close_up_limit(errors, calibration.selection);
  if (limit > 0.0) {
    render::Panel near = close_up_panel(calibration, errors, limit, symbol, "%");
    add_interval_of_reference(near, calibration);
    share_legend(out.figure.panels.front(), near);
    out.figure.panels.push_back(std::move(near));
    out.figure.panels_share_x = true;
    out.figure.height_px = 1400;
  }

  std::vector<std::string> words;
  for (const std::string& name :
       {calibration.selection.paper_rule, calibration.selection.recommended}) {
    const std::string rms = rms_words(quality, name);
    if (!rms.empty() && (words.empty() || words.back() != rms)) words.push_back(rms);
  }
  const std::string chosen =
      words.empty() ? std::string() : " Root mean square over the runs: " + listed(words) + ".";
  const std::string left_out =
      quality.runs_left_out == 0
          ? std::string()
          : fmt::format(" {} without a reference, or with a driving torque near zero, left out.",
                        counted(quality.runs_left_out, "run"));
  const std::string known_to =
      quality.reference_rms_percent > 0.0
          ? fmt::format(" Bars about zero: 95 % interval of the reference itself, ± {} rms.",
                        size_words(quality.reference_rms_percent, percent_floor, "%"))
          : std::string();
  out.caption = fmt::format("Error of each candidate against the reference ({}).{}{}{}",
                            reference_words(quality.reference), chosen, known_to, left_out);
  out.how_to_read =
      "The closer to zero over all speeds the better the mass. A wrong mass gives a level line in "
      "each direction, a step apart because the driving torque differs; scatter of the same size "
      "as the distance between two candidates means that the runs cannot choose between them.";
  if (quality.reference_rms_percent > 0.0) {
    out.how_to_read += " An error within its bar says nothing: the reference is no better known.";
  }
  out.alt = fmt::format("Error of {} in percent of the driving torque against {} speed.{}",
                        counted(errors.size(), "candidate"), shaft(calibration.manifest), chosen);
  return out;
}

}  // namespace tribolog::figures
