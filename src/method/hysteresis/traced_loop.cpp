#include "method/hysteresis/traced_loop.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "method/hysteresis/turn_stiffness.h"
#include "statistics/white_noise.h"

namespace tribolog {
namespace {

/// A fit that leaves more than this many times what noise explains is no LuGre joint's. Of one that
/// is, smoothing takes part of the angle's noise away, and it leaves less than once.
constexpr double misfit_factor = 1.5;

/// Nor does a misfit count that is smaller than this share of the torque's range: no drive follows
/// a friction model more closely.
constexpr double smallest_misfit_share = 1e-4;

/// The strokes that begin at a turn.
std::vector<StrokeSamples> strokes_behind_turns(const Recording& r, const TracedMotion& motion) {
  std::vector<StrokeSamples> strokes;
  const auto index_of = [&](double since_s) {
    const auto it = std::lower_bound(r.t_s.begin(), r.t_s.end(), r.t_s.front() + since_s);
    return static_cast<std::size_t>(it - r.t_s.begin());
  };
  for (std::size_t k = 0; k < motion.turns_s.size(); ++k) {
    const bool is_last = k + 1 == motion.turns_s.size();
    strokes.push_back({std::min(index_of(motion.turns_s[k]), r.size() - 1),
                       is_last ? r.size() : index_of(motion.turns_s[k + 1])});
  }
  return strokes;
}

}  // namespace

TracedLoop describe_traced_loop(const Recording& recording, const TracedMotion& motion,
                                const std::vector<double>& model_Nm,
                                const std::vector<double>& slope_Nm_rad, double gear_ratio) {
  TracedLoop out;
  out.noise_rad = motion.noise_rad;
  out.noise_in_words = motion.noise_in_words();
  out.strokes = motion.strokes();
  double squares = 0;
  for (const double slope : slope_Nm_rad) squares += slope * slope;
  out.explained_Nm = std::hypot(
      gear_ratio * motion.noise_rad * std::sqrt(squares / static_cast<double>(slope_Nm_rad.size())),
      white_sd_beside_jumps(third_differences(recording.torque_Nm)));
  const auto [low, high] =
      std::minmax_element(recording.torque_Nm.begin(), recording.torque_Nm.end());
  out.explained_Nm = std::max(out.explained_Nm, smallest_misfit_share * (*high - *low));
  const std::vector<StrokeSamples> strokes = strokes_behind_turns(recording, motion);
  out.turn_stiffness_Nm_rad =
      stiffness_behind_turns(recording.q_rad, recording.torque_Nm, recording.torque_Nm, strokes);
  out.model_turn_stiffness_Nm_rad =
      stiffness_behind_turns(recording.q_rad, recording.torque_Nm, model_Nm, strokes);
  return out;
}

std::string misfit_in_words(const std::string& recording, const TracedLoop& loop,
                            double residual_Nm) {
  if (residual_Nm <= misfit_factor * loop.explained_Nm) return "";
  std::string words = fmt::format(
      "{}: the model leaves {:.2g} N·m (standard deviation) where the noise of angle and torque "
      "explains {:.2g} N·m: friction of this joint is not LuGre's, and its numbers are those of "
      "the LuGre model that comes closest",
      recording, residual_Nm, loop.explained_Nm);
  if (loop.turn_stiffness_Nm_rad && loop.model_turn_stiffness_Nm_rad) {
    words += fmt::format(
        "; behind a reversal the model is {:.3g} N·m/rad stiff at the joint angle, the joint was "
        "measured to be {:.3g} N·m/rad stiff",
        loop.model_turn_stiffness_Nm_rad->value, loop.turn_stiffness_Nm_rad->value);
  }
  return words;
}

}  // namespace tribolog
