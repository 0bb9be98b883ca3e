// What the history's states are called.

#include <fmt/format.h>

#include "history/joint_trend.h"

namespace tribolog::history {

std::string to_string(LeftOut why) {
  switch (why) {
    case LeftOut::none:
      return "used";
    case LeftOut::before_baseline:
      return "before the baseline";
    case LeftOut::not_usable:
      return "verdict not usable";
    case LeftOut::other_gear:
      return "another gear ratio than the latest";
    case LeftOut::other_payload:
      return "another payload than the latest";
    case LeftOut::no_temperature:
      return "temperature not stated";
  }
  return "";
}

std::string to_string(TemperatureUse use) {
  switch (use) {
    case TemperatureUse::corrected:
      return "temperature is taken into account by a straight line";
    case TemperatureUse::hardly_felt:
      return "it hardly depends on temperature";
    case TemperatureUse::too_even:
      return fmt::format(
          "temperature varied by less than {:.3g} K, too little to tell its effect; nothing is "
          "corrected",
          least_temperature_span_K);
    case TemperatureUse::not_recorded:
      return "temperature is stated by fewer than half of the calibrations: a change may be its";
  }
  return "";
}

std::string to_string(TrendState state) {
  switch (state) {
    case TrendState::too_few:
      return "too few calibrations yet";
    case TrendState::steady:
      return "no change visible";
    case TrendState::recovered:
      return "changed, and back";
    case TrendState::warning:
      return "changed";
  }
  return "";
}

}  // namespace tribolog::history
