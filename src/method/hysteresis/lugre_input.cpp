#include "method/hysteresis/lugre_input.h"

#include <algorithm>

namespace tribolog {

std::shared_ptr<const Motion> LuGreInput::motor_motion(double gear_ratio) const {
  if (traced != nullptr) return traced->motor_motion(gear_ratio);
  return std::make_shared<HarmonicMotion>(motion->motor_motion(gear_ratio));
}

double LuGreInput::frequency_Hz() const {
  return traced != nullptr ? traced->frequency_Hz : motion->frequency_Hz;
}

double LuGreInput::centre_rad() const {
  return traced != nullptr ? traced->centre_rad : motion->centre_rad;
}

std::vector<std::size_t> LuGreInput::half_loops() const {
  std::vector<std::size_t> out;
  const auto& t = recording->t_s;
  for (const double time : t) {
    const double since = time - t.front();
    if (traced == nullptr) {
      out.push_back(static_cast<std::size_t>(since * 2 * motion->frequency_Hz));
    } else {
      const auto& turns = traced->turns_s;
      out.push_back(static_cast<std::size_t>(std::upper_bound(turns.begin(), turns.end(), since) -
                                             turns.begin()));
    }
  }
  return out;
}

}  // namespace tribolog
