// Does the joint move, and can its angle be an angle in radians?

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include <Eigen/Core>

#include "method/checks/check_list.h"
#include "statistics/linear_systems.h"

namespace tribolog::method::checks {

DataCheck check_joint_moves(const CheckedDataset& data) {
  DataCheck check;
  check.name = CheckName::joint_moves;
  check.measure = {"measure.moving_recordings"};
  check.unit = percent_sign;
  check.at_least = 100;
  RecordingCounts moving;
  for (const CheckedRecording& r : data.recordings) {
    if (r.recording->role == joint::Role::break_away) continue;  // it may stand from end to end
    moving.add(!r.strokes.empty(), r.recording->name);
  }
  if (moving.all() == 0) {
    return not_applicable(check.name, {"not_applicable.none_has_to_move"});
  }
  moving.take_share(check);
  if (moving.others() == 0) return passed_by_all(check, {"joint_moves.in_all"});
  check.state = CheckState::fails;
  check.found = {"joint_moves.angle_stands",
                 {{"standing", moving.others()}, {"recordings", moving.all()}}};
  check.consequence = {"joint_moves.shows_nothing"};
  check.experiment = {"joint_moves.see_drive_and_column"};
  return check;
}

// Least squares of a level for each direction and one wave per turn; the wave has to explain the
// residual of the levels.
bool torque_follows_the_cosine(const CheckedDataset& data, double least_range_rad) {
  constexpr double least_share = 0.95;
  constexpr std::size_t most_rows = 2000;
  Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  double squares = 0;
  double range_rad = 0;
  for (const CheckedRecording* r : data.with_role(joint::Role::rough_sweep)) {
    if (r->recording->torque_Nm.empty()) continue;
    const std::size_t stride = std::max<std::size_t>(1, r->recording->size() / most_rows);
    for (const motion::Stroke& way : r->ways()) {
      range_rad = std::max(range_rad, way.travel_rad);
      for (std::size_t i = way.first; i < way.last; i += stride) {
        const double q = r->recording->q_rad[i];
        const double torque = r->recording->torque_Nm[i];
        const Eigen::Vector4d row{way.direction > 0 ? 1.0 : 0.0, way.direction > 0 ? 0.0 : 1.0,
                                  std::cos(q), std::sin(q)};
        normal += row * row.transpose();
        right += torque * row;
        squares += torque * torque;
      }
    }
  }
  if (range_rad < least_range_rad) return false;
  const auto left_by = [&](const Eigen::MatrixXd& n, const Eigen::VectorXd& b) {
    return squares - b.dot(statistics::least_squares(n, b).col(0));
  };
  const double by_levels = left_by(normal.topLeftCorner<2, 2>(), right.head<2>());
  constexpr double rounding = 1e-9;  // of the torque's square: friction alone leaves no more
  if (by_levels <= rounding * squares) return false;
  return left_by(normal, right) <= (1 - least_share) * by_levels;
}

namespace {

/// Whether the log states a unit of the angle that is not the radian: then degrees are not taken
/// for radians, and a joint that is logged from 0 to 360 degrees may pass 360.
bool has_stated_other_unit(const CheckedDataset& data) {
  bool any = false;
  for (const joint::InputFile& input : *data.inputs) {
    for (const joint::ColumnConversion& c : input.conversions) {
      if (c.signal != joint::LoggedSignal::angle) continue;
      if (c.unit == "rad" || c.is_proposed) return false;
      any = true;
    }
  }
  return any;
}

}  // namespace

DataCheck check_angle_unit(const CheckedDataset& data) {
  // An axis that nothing loads may turn as far as it will.
  if (data.has_no_gravity()) {
    return not_applicable(CheckName::angle_unit, {"not_applicable.no_gravity"});
  }
  // A little more than one turn: few joints of a robot turn further, all do in degrees.
  constexpr double largest_likely_rad = 7.0;
  DataCheck check;
  check.name = CheckName::angle_unit;
  check.measure = {"measure.largest_angle"};
  check.unit = "rad";
  check.at_most = largest_likely_rad;
  const bool of_range = has_stated_other_unit(data);
  double largest = 0;
  for (const CheckedRecording& r : data.recordings) {
    const double reach =
        of_range ? r.range_rad() : std::max(std::abs(r.lowest_rad), std::abs(r.highest_rad));
    if (reach < largest || r.recording->size() < 2) continue;
    largest = reach;
    check.recording = r.recording->name;
  }
  check.measured = largest;
  if (largest <= largest_likely_rad) {
    return passed_by_all(check, {"angle_unit.of_a_joint"});
  }
  constexpr double quarter_turn_rad = std::numbers::pi / 2;
  if (torque_follows_the_cosine(data, quarter_turn_rad)) {
    return passed_by_all(check, {"angle_unit.torque_follows"});
  }
  check.state = CheckState::fails;
  check.found = {"angle_unit.too_large",
                 {{"largest_rad", largest}, {"turns", largest / (2 * std::numbers::pi)}}};
  check.consequence = {"angle_unit.gravity_not_found"};
  check.experiment = {"angle_unit.state_unit_and_side"};
  return check;
}

// The oscillation: how many cycles, and whether friction reverses within it.

namespace {

constexpr std::size_t bins = 20;  // of a stroke

/// Stiffness of the loop towards the end of its strokes, in % of that after the reversals: 0 where
/// friction has reached its level, 100 for a spring.
std::optional<double> stiffness_left_percent(const CheckedRecording& r) {
  constexpr double whole_stroke = 0.8;  // of the range: the start-up stroke is shorter
  // Each direction for itself: gravity is far larger than what is looked for.
  std::array<std::array<double, bins>, 2> sum{};
  std::array<std::array<std::size_t, bins>, 2> count{};
  for (const motion::Stroke& stroke : r.strokes) {
    if (stroke.travel_rad < whole_stroke * r.range_rad()) continue;
    const std::size_t way = stroke.direction > 0 ? 0 : 1;
    const double start = r.recording->q_rad[stroke.first];
    for (std::size_t i = stroke.first; i < stroke.last; ++i) {
      const double place = std::abs(r.recording->q_rad[i] - start) / stroke.travel_rad;
      if (!(place >= 0 && place < 1)) continue;
      const auto k = static_cast<std::size_t>(place * bins);
      sum[way][k] += r.recording->torque_Nm[i];
      ++count[way][k];
    }
  }
  for (const auto& counts : count) {
    if (std::any_of(counts.begin(), counts.end(), [](std::size_t c) { return c == 0; })) {
      return std::nullopt;
    }
  }
  const auto mean = [&](std::size_t k) {
    return (sum[0][k] / static_cast<double>(count[0][k]) -
            sum[1][k] / static_cast<double>(count[1][k])) /
           2;
  };
  // Per bin. In a wide loop friction has risen from the level before the turn within half of the
  // first one.
  const double behind_turn =
      mean(0) > 0 ? (mean(0) + mean(bins - 1)) / 0.5 : (mean(2) - mean(0)) / 2;
  const double at_end = (mean(bins - 2) - mean(bins - 6)) / 4;
  if (!(behind_turn > 0)) return std::nullopt;
  return std::max(0.0, 100 * at_end / behind_turn);
}

}  // namespace

DataCheck check_oscillation_cycles(const CheckedDataset& data) {
  constexpr double fewest = 3;
  constexpr double enough = 5;
  DataCheck check;
  check.name = CheckName::oscillation_cycles;
  check.measure = {"measure.cycles"};
  check.unit = pure_number;
  check.at_least = enough;
  for (const CheckedRecording* r : data.with_role(joint::Role::oscillation)) {
    if (r->strokes.empty()) continue;
    const double cycles = static_cast<double>(r->strokes.size() - 1) / 2;  // two turns each
    if (check.measured && cycles >= *check.measured) continue;
    check.measured = cycles;
    check.recording = r->recording->name;
  }
  if (!check.measured) {
    return not_applicable(check.name, {"not_applicable.no_oscillation"});
  }
  check.found = {"oscillation_cycles.recorded", {{"cycles", *check.measured}}};
  check.state = *check.measured >= enough   ? CheckState::passed
                : *check.measured >= fewest ? CheckState::warns
                                            : CheckState::fails;
  if (check.state == CheckState::passed) return check;
  check.consequence = {"oscillation_cycles.too_few"};
  check.experiment = {"oscillation_cycles.record_ten"};
  return check;
}

DataCheck check_oscillation_slides(const CheckedDataset& data) {
  constexpr double warning_percent = 10;
  constexpr double most_percent = 30;
  DataCheck check;
  check.name = CheckName::oscillation_slides;
  if (!data.has_torque) {
    return not_applicable(check.name, {"not_applicable.no_torque"});
  }
  check.measure = {"measure.stiffness_left"};
  check.unit = percent_sign;
  check.at_most = warning_percent;
  for (const CheckedRecording* r : data.with_role(joint::Role::oscillation)) {
    const auto left = stiffness_left_percent(*r);
    // The largest stroke decides: smaller ones beside it add to what it shows.
    if (!left || (check.measured && *left >= *check.measured)) continue;
    check.measured = left;
    check.recording = r->recording->name;
  }
  if (!check.measured) {
    return not_applicable(check.name, {"not_applicable.no_whole_strokes"});
  }
  check.found = {"oscillation_slides.stiffness_left", {{"stiffness_percent", *check.measured}}};
  check.state = passed_or_warns_up_to(most_percent, check);
  if (check.state == CheckState::passed) return check;
  check.consequence = {"oscillation_slides.stroke_too_small"};
  check.experiment = {"record.larger_amplitude"};
  return check;
}

// Stick-slip: in slow motion the joint rests, springs on in the same direction, and rests again.

namespace {

constexpr double rest_share = 0.1;      // of the stroke's mean speed: slower is rest
constexpr double burst_share = 1.5;     // faster is a burst
constexpr double steps_in_window = 20;  // of the encoder, at the mean speed
constexpr std::size_t fewest_samples_in_window = 5;

/// How often a stroke stops and springs on.
std::size_t stops_within(const CheckedRecording& r, const motion::Stroke& stroke) {
  const joint::Recording& log = *r.recording;
  const double duration = log.t_s[stroke.last] - log.t_s[stroke.first];
  if (!(duration > 0)) return 0;
  const double mean = stroke.travel_rad / duration;
  const auto window =
      std::max(fewest_samples_in_window,
               static_cast<std::size_t>(steps_in_window * r.angle_step_rad / mean / r.interval_s));
  bool rested = false;
  bool burst_before = false;
  std::size_t stops = 0;
  // The ends of a stroke are at rest anyhow, so a rest counts between two bursts only.
  for (std::size_t i = stroke.first; i + window <= stroke.last; ++i) {
    const double speed = stroke.direction * (log.q_rad[i + window] - log.q_rad[i]) /
                         (log.t_s[i + window] - log.t_s[i]);
    if (speed > burst_share * mean) {
      if (burst_before && rested) ++stops;
      burst_before = true;
      rested = false;
    } else if (speed < rest_share * mean) {
      rested = true;
    }
  }
  return stops;
}

}  // namespace

DataCheck check_stick_slip(const CheckedDataset& data) {
  constexpr double most_stops = 4;
  DataCheck check;
  check.name = CheckName::stick_slip;
  check.measure = {"measure.stops"};
  check.unit = pure_number;
  check.at_most = most_stops;
  std::size_t affected = 0;
  for (const CheckedRecording& r : data.recordings) {
    if (!r.travels()) continue;
    std::size_t stops = 0;
    for (const motion::Stroke& stroke : r.strokes) stops = std::max(stops, stops_within(r, stroke));
    const auto count = static_cast<double>(stops);
    if (count > most_stops) ++affected;
    take_if_worst(check, count, r.recording->name);
  }
  if (!check.measured) return not_applicable(check.name, {"not_applicable.no_sweep_or_run"});
  if (affected == 0) {
    return passed_by_all(check, {"stick_slip.moves_on"});
  }
  check.state = CheckState::fails;
  check.found = {"stick_slip.stops", {{"stops", *check.measured}, {"recordings", affected}}};
  check.consequence = {"stick_slip.torque_of_no_one_speed"};
  check.experiment = {"stick_slip.move_faster"};
  return check;
}

}  // namespace tribolog::method::checks
