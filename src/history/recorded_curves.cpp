#include "history/recorded_curves.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <nlohmann/json.hpp>

#include "calibration/json_values.h"

namespace tribolog::history {
namespace {

using Recorded = nlohmann::json;
using calibration::member;

double number(const Recorded& value) {
  return value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

std::vector<double> numbers(const Recorded& list) {
  std::vector<double> values;
  if (!list.is_array()) return values;
  for (const Recorded& value : list) values.push_back(number(value));
  return values;
}

RecordedFriction friction_of(const Recorded& top) {
  const Recorded& viscous = calibration::member(top, "viscous");
  const Recorded& runs = calibration::member(viscous, "runs");
  const Recorded& chosen =
      calibration::member(calibration::member(top, "selection"), "recommended");
  const Recorded& curves = calibration::member(viscous, "curves");
  if (!runs.is_array() || !chosen.is_string()) return {};
  const std::vector<double> friction =
      numbers(calibration::member(curves, chosen.get<std::string>()));
  if (friction.size() != runs.size()) return {};
  RecordedFriction made;
  made.estimator = chosen.get<std::string>();
  for (std::size_t k = 0; k < friction.size(); ++k) {
    const double speed = number(calibration::member(runs[k], "speed_rad_s"));
    if (!std::isfinite(speed) || !std::isfinite(friction[k])) continue;
    made.speed_rad_s.push_back(speed);
    made.friction_Nm.push_back(friction[k]);
    made.half_width_Nm.push_back(number(calibration::member(runs[k], "torque_half_width_Nm")));
  }
  return made;
}

std::vector<RecordedLoop> loops_of(const Recorded& top) {
  std::vector<RecordedLoop> loops;
  const Recorded& oscillations =
      calibration::member(calibration::member(top, "hysteresis"), "oscillations");
  if (!oscillations.is_array()) return loops;
  for (const Recorded& oscillation : oscillations) {
    const Recorded& steady = calibration::member(oscillation, "steady_loop");
    RecordedLoop loop;
    loop.centre_rad = number(calibration::member(steady, "centre_rad"));
    loop.from_centre_rad = numbers(calibration::member(steady, "angle_from_centre_rad"));
    loop.torque_Nm = numbers(calibration::member(steady, "torque_Nm"));
    const bool is_whole = std::isfinite(loop.centre_rad) && loop.torque_Nm.size() > 2 &&
                          loop.torque_Nm.size() == loop.from_centre_rad.size();
    if (is_whole) loops.push_back(std::move(loop));
  }
  return loops;
}

}  // namespace

RecordedCurves recorded_curves(const std::string& json) {
  const Recorded top = Recorded::parse(json, nullptr, false);
  if (top.is_discarded()) return {};
  return {friction_of(top), loops_of(top)};
}

}  // namespace tribolog::history
