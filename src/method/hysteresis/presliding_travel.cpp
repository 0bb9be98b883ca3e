#include "method/hysteresis/presliding_travel.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/requirements.h"
#include "method/motion/plateaus.h"
#include "statistics/order_statistics.h"

namespace tribolog::method::hysteresis {
namespace {

/// Travels of one recording, one per reversal.
void add_travels(const joint::Recording& r, const std::vector<bool>& steady,
                 const gravity::CogSweepResult& found, double gear_ratio,
                 std::vector<double>& travels) {
  const double coulomb = present(found.coulomb_Nm).value;
  // At a reversal acceleration is largest: without inertia friction would seem to turn over early.
  const double inertia = found.inertia_kgm2 ? found.inertia_kgm2->value * gear_ratio : 0.0;
  const std::vector<double> acceleration = motion::find_plateaus(r).acceleration_rad_s2;
  const auto friction = [&](std::size_t i) {
    return r.torque_Nm[i] - found.offset_Nm - inertia * acceleration[i] -
           found.gravity_Nm.value * std::cos(r.q_rad[i] - found.q_peak_rad.value);
  };
  // A reversal is the unsteady stretch between two steady ones of opposite direction.
  for (std::size_t i = 1; i < r.size(); ++i) {
    if (steady[i] || !steady[i - 1]) continue;
    std::size_t end = i;
    while (end < r.size() && !steady[end]) ++end;
    const std::size_t reach = std::min(r.size(), end + (end - i));
    if (end == r.size() || i < 2) break;
    const double before = r.q_rad[i - 1] > r.q_rad[i - 2] ? 1.0 : -1.0;
    std::size_t turn = i;
    for (std::size_t k = i; k < end; ++k) {
      if (before * r.q_rad[k] > before * r.q_rad[turn]) turn = k;
    }
    for (std::size_t k = turn; k + 2 < reach; ++k) {
      const double mean = (friction(k) + friction(k + 1) + friction(k + 2)) / 3;
      if (before * mean < -0.7 * coulomb) {
        travels.push_back(std::abs(r.q_rad[k + 1] - r.q_rad[turn]));
        break;
      }
    }
    i = end;
  }
}

}  // namespace

std::optional<double> presliding_travel_rad(const motion::Sweep& sweep,
                                            const gravity::CogSweepResult& found,
                                            double gear_ratio) {
  if (!found.found || !found.coulomb_Nm || !(found.coulomb_Nm->low > 0)) return std::nullopt;
  const std::vector<std::vector<bool>> steady = sweep.used();
  std::vector<double> travels;
  for (std::size_t k = 0; k < sweep.recordings.size(); ++k) {
    add_travels(*sweep.recordings[k], steady[k], found, gear_ratio, travels);
  }
  if (travels.empty()) return std::nullopt;
  return statistics::median(std::move(travels));
}

}  // namespace tribolog::method::hysteresis
