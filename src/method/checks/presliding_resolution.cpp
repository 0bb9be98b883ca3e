// Does the encoder resolve pre-sliding: the width of the recorded loop, or, without one, the travel
// after a reversal of the sweep within which friction reverses?

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "method/checks/check_list.h"
#include "method/motion/encoder_resolution.h"
#include "statistics/order_statistics.h"

namespace tribolog::method::checks {
namespace {

constexpr double turned_over = 0.75;  // of the full difference of the ways in and out
constexpr double level_from = 0.005;  // of the stroke: from here on friction has turned over,
constexpr double level_to = 0.02;     // and up to here the speed has hardly changed it

/// Torque over the distance from a reversal: the mean of the samples on each step of the encoder.
class TorqueOverDistance {
 public:
  TorqueOverDistance(const CheckedRecording& r, const motion::Stroke& stroke, double turn_rad,
                     double reach_rad) {
    struct Sums {
      double torque{}, count{};
    };
    std::map<long, Sums> steps;
    for (std::size_t i = stroke.first; i <= stroke.last; ++i) {
      const double distance = std::abs(r.recording->q_rad[i] - turn_rad);
      if (distance > reach_rad) continue;
      Sums& sums = steps[std::lround(distance / r.angle_step_rad)];
      sums.torque += r.recording->torque_Nm[i];
      sums.count += 1;
    }
    for (const auto& [step, sums] : steps) {
      distance_rad_.push_back(static_cast<double>(step) * r.angle_step_rad);
      torque_Nm_.push_back(sums.torque / sums.count);
    }
  }

  [[nodiscard]] std::size_t size() const { return distance_rad_.size(); }
  /// Linear interpolation; constant beyond the last sample.
  [[nodiscard]] double at(double distance_rad) const {
    const auto next = std::upper_bound(distance_rad_.begin(), distance_rad_.end(), distance_rad);
    const auto k = static_cast<std::size_t>(next - distance_rad_.begin());
    if (k == 0) return torque_Nm_.front();
    if (k == distance_rad_.size()) return torque_Nm_.back();
    const double share =
        (distance_rad - distance_rad_[k - 1]) / (distance_rad_[k] - distance_rad_[k - 1]);
    return torque_Nm_[k - 1] + share * (torque_Nm_[k] - torque_Nm_[k - 1]);
  }

 private:
  std::vector<double> distance_rad_;
  std::vector<double> torque_Nm_;
};

/// Travel after one reversal within which the torque separates from that before it, at equal angle:
/// gravity and inertia are the same in both, and drop out.
std::optional<double> travel_of_turn(const CheckedRecording& r, const motion::Stroke& in,
                                     const motion::Stroke& out) {
  constexpr std::size_t fewest_distances = 10;
  constexpr int levels = 20;
  constexpr double most_steps = 1e6;
  const double step = r.angle_step_rad;
  const double reach = level_to * std::min(in.travel_rad, out.travel_rad);
  if (reach / step > most_steps) return std::nullopt;
  const double turn = r.recording->q_rad[out.first];
  const TorqueOverDistance way_in(r, in, turn, reach);
  const TorqueOverDistance way_out(r, out, turn, reach);
  if (std::min(way_in.size(), way_out.size()) < fewest_distances) return std::nullopt;
  const auto difference = [&](double distance) {
    return in.direction * (way_in.at(distance) - way_out.at(distance));
  };
  std::vector<double> level;
  const double from = level_from / level_to * reach;
  for (int k = 0; k <= levels; ++k) level.push_back(difference(from + (reach - from) * k / levels));
  const double full = statistics::median(std::move(level));
  if (!(full > 0)) return std::nullopt;
  for (double distance = step; distance < from; distance += step) {
    if (difference(distance) >= turned_over * full) return distance;
  }
  return std::nullopt;
}

struct Resolution {
  double steps{};
  double travel_rad{};
  double step_rad{};
  bool step_is_of_print{};
  std::string recording;
};

std::optional<Resolution> of_oscillations(const CheckedDataset& data) {
  std::optional<Resolution> worst;
  for (const CheckedRecording* r : data.with_role(joint::Role::oscillation)) {
    if (r->angle_step_rad <= 0) continue;
    const double steps = r->range_rad() / r->angle_step_rad;
    if (worst && steps >= worst->steps) continue;
    worst = {steps, r->range_rad(), r->angle_step_rad, r->step_is_of_print, r->recording->name};
  }
  return worst;
}

std::optional<Resolution> of_reversals(const CheckedDataset& data) {
  std::vector<double> travels;
  std::optional<Resolution> found;
  for (const CheckedRecording* r : data.with_role(joint::Role::rough_sweep)) {
    if (r->angle_step_rad <= 0 || !data.has_torque) continue;
    for (std::size_t k = 0; k + 1 < r->strokes.size(); ++k) {
      const auto travel = travel_of_turn(*r, r->strokes[k], r->strokes[k + 1]);
      if (!travel) continue;
      travels.push_back(*travel);
      found = {0, 0, r->angle_step_rad, r->step_is_of_print, r->recording->name};
    }
  }
  if (!found) return std::nullopt;
  found->travel_rad = statistics::median(std::move(travels));
  found->steps = found->travel_rad / found->step_rad;
  return found;
}

}  // namespace

DataCheck check_encoder_step(const CheckedDataset& data) {
  DataCheck check;
  check.name = CheckName::encoder_step;
  check.unit = pure_number;
  check.at_least = motion::fewest_steps_in_presliding;
  const bool has_loop = data.has_role(joint::Role::oscillation);
  const auto worst = has_loop ? of_oscillations(data) : of_reversals(data);
  if (!worst) {
    if (has_loop) {
      return passed_by_all(check, {"encoder_step.continuous"});
    }
    return not_applicable(check.name, {"not_applicable.no_stepped_reversal"});
  }
  check.recording = worst->recording;
  check.measure =
      has_loop ? Code{"measure.steps_across_loop"} : Code{"measure.steps_after_reversal"};
  check.measured = worst->steps;
  check.found = {
      worst->step_is_of_print ? Code{"encoder_step.steps_of_print"} : Code{"encoder_step.steps"},
      {{"steps", worst->steps},
       {"step_rad", worst->step_rad},
       {"travel_rad", worst->travel_rad},
       {"needed", motion::fewest_steps_in_presliding}}};
  check.state =
      worst->steps >= motion::fewest_steps_in_presliding ? CheckState::passed : CheckState::fails;
  if (check.state == CheckState::passed) return check;
  check.consequence = {"encoder_step.presliding_not_resolved"};
  check.experiment = {"encoder_step.record_finer"};
  return check;
}

}  // namespace tribolog::method::checks
