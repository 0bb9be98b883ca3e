// How many different speeds the runs at constant speed hold.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "method/checks/check_list.h"

namespace tribolog {

DataCheck check_run_speeds(const CheckedDataset& data) {
  constexpr double same_speed = 1.1;  // ratio of two speeds that count as one
  constexpr std::size_t fewest = 5;   // the curve of eq. (6) has five parameters
  constexpr std::size_t fewest_for_a_line = 3;
  DataCheck check;
  check.name = "run_speeds";
  check.title = "Number of speeds";
  const auto runs = data.with_role(Role::constant_speed);
  if (runs.empty()) return not_applicable(check.name, check.title, "no runs at constant speed");
  std::vector<double> speeds;
  for (const CheckedRecording* r : runs) {
    for (const Plateau& plateau : r->motion.plateaus) {
      speeds.push_back(std::abs(plateau.speed_rad_s));
    }
  }
  std::sort(speeds.begin(), speeds.end());
  std::size_t different = 0;
  double last = 0;
  for (const double speed : speeds) {
    if (speed <= same_speed * last) continue;
    ++different;
    last = speed;
  }
  check.recording = "all";
  check.measure = "different speeds among the plateaus";
  check.unit = pure_number;
  check.at_least = static_cast<double>(fewest);
  check.measured = static_cast<double>(different);
  check.found = fmt::format("{} plateaus at {} different speed{}", speeds.size(), different,
                            different == 1 ? "" : "s");
  if (different >= fewest) {
    check.state = CheckState::passed;
    return check;
  }
  check.state = different >= fewest_for_a_line ? CheckState::warns : CheckState::fails;
  check.consequence =
      "how friction changes with speed cannot be told from so few: neither the "
      "viscous coefficient nor the Stribeck velocity";
  check.experiment =
      "run the joint at ten to twenty speeds, from the slowest smooth one to the "
      "fastest allowed, in both directions";
  return check;
}

}  // namespace tribolog
