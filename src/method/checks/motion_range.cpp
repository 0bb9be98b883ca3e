// Does the joint move, and can its angle be an angle in radians?

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "method/checks/check_list.h"

namespace tribolog {

DataCheck check_joint_moves(const CheckedDataset& data) {
  DataCheck check;
  check.name = "joint_moves";
  check.title = "The joint moves";
  check.measure = "recordings in which the joint moves";
  check.unit = percent_sign;
  check.at_least = 100;
  RecordingsAsWanted moving;
  for (const CheckedRecording& r : data.recordings) {
    if (r.recording->role == Role::break_away) continue;  // it may stand from end to end
    moving.add(!r.strokes.empty(), r.recording->name);
  }
  if (moving.all() == 0) {
    return not_applicable(check.name, check.title, "no recording in which it has to move");
  }
  moving.take_share(check);
  if (moving.others() == 0) return passed_by_all(check, "the joint moves in every recording");
  check.state = CheckState::fails;
  check.found =
      fmt::format("the angle stands still in {} of {} recordings", moving.others(), moving.all());
  check.consequence = "a joint that stands shows neither gravity's angle nor friction";
  check.experiment = "see that the joint was driven and that the angle's column is alive";
  return check;
}

DataCheck check_angle_unit(const CheckedDataset& data) {
  // A little more than one turn: few joints of a robot turn further, all do in degrees.
  constexpr double largest_likely_rad = 7.0;
  DataCheck check;
  check.name = "angle_unit";
  check.title = "The angle's unit";
  check.measure = "largest joint angle";
  check.unit = "rad";
  check.at_most = largest_likely_rad;
  double largest = 0;
  for (const CheckedRecording& r : data.recordings) {
    const double reach = std::max(std::abs(r.lowest_rad), std::abs(r.highest_rad));
    if (reach < largest || r.recording->size() < 2) continue;
    largest = reach;
    check.recording = r.recording->name;
  }
  check.measured = largest;
  if (largest <= largest_likely_rad) {
    return passed_by_all(check, "the angles are those of a joint");
  }
  check.state = CheckState::fails;
  check.found = fmt::format(
      "the joint's angle reaches {:.4g} rad, {:.3g} turns: degrees taken for radians, or the "
      "motor's angle for the joint's?",
      largest, largest / (2 * std::numbers::pi));
  check.consequence =
      "gravity follows the cosine of the angle: in a wrong unit it is not found, "
      "or found wrongly, and so is all that rests on it";
  check.experiment = "state the unit and the side of the angle's column as they are";
  return check;
}

}  // namespace tribolog
