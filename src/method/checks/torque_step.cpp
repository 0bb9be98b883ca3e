// The step of the torque against the friction it has to show.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "method/checks/check_list.h"
#include "method/checks/direction_difference.h"
#include "method/motion/encoder_resolution.h"

namespace tribolog {

DataCheck check_torque_step(const CheckedDataset& data) {
  constexpr double warning_percent = 10;
  constexpr double most_percent = 25;
  DataCheck check;
  check.name = "torque_step";
  check.title = "Torque step against friction";
  if (!data.has_torque) {
    return not_applicable(check.name, check.title, "no torque was recorded");
  }
  check.measure = "step of the torque / half the difference of the directions";
  check.unit = percent_sign;
  check.at_most = warning_percent;
  double worst_step = 0;
  double its_friction = 0;
  for (const Role role : {Role::rough_sweep, Role::oscillation, Role::constant_speed}) {
    const auto recordings = data.with_role(role);
    const DirectionDifference d = direction_difference(recordings, true);
    if (d.common_bins == 0 || d.friction_Nm == 0) continue;
    for (const CheckedRecording* r : recordings) {
      const double step = common_step(r->recording->torque_Nm);
      const double percent = 100 * step / std::abs(d.friction_Nm);
      if (!take_if_worst(check, percent, r->recording->name)) continue;
      worst_step = step;
      its_friction = std::abs(d.friction_Nm);
    }
  }
  if (!check.measured) {
    return not_applicable(check.name, check.title,
                          "no recording has both directions over the same angles");
  }
  if (worst_step == 0) {
    return passed_by_all(check, "the torque looks continuous");
  }
  check.found =
      fmt::format("steps of {:.3g} N·m against {:.3g} N·m, at the motor", worst_step, its_friction);
  check.state = passed_or_warns_up_to(most_percent, check);
  if (check.state == CheckState::passed) return check;
  check.consequence =
      "friction is read in few steps, and where noise does not spread the samples "
      "over several of them no mean makes up for it";
  check.experiment = "record the current with more digits, or in a smaller measuring range";
  return check;
}

}  // namespace tribolog
