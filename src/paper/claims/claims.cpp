#include "paper/claims/claims.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/requirements.h"
#include "identify/identify.h"
#include "joint/degrees.h"
#include "simulate/simulate_joint.h"
#include "wording/number_text.h"
#include "wording/rounding.h"
#include "wording/tr.h"

namespace tribolog::paper::claims {

namespace {

using method::hysteresis::Estimator;
using wording::tr;
using wording::with_unit;

// What counts as the same: a thousandth of the mass, a twentieth of a degree, a fiftieth of
// friction.
constexpr double same_mass_percent = 0.1;
constexpr double same_angle_deg = 0.05;
constexpr double same_friction_percent = 2;

std::string percent(double value) { return with_unit(wording::fixed(value, 2), "%"); }

Finding cannot_be_asked(std::string why) { return {std::nullopt, std::move(why)}; }

double true_mass_kg(const ArguedJoint& joint) {
  const joint::GravityLoad& load = joint.scenario.load;
  return load.mass_kg() * load.distance_m() / joint.scenario.surrogate_distance_m;
}

/// Error of an estimator's mass [%]; nothing where there is none.
std::optional<double> mass_error_percent(const ArguedJoint& joint, Estimator estimator) {
  const method::hysteresis::SurrogateMass* mass = joint.calibration.masses.find(estimator);
  if (mass == nullptr) return std::nullopt;
  return 100 * (mass->mass_kg.value / true_mass_kg(joint) - 1);
}

struct PointError {
  Estimator point{};
  double percent{};
};

/// Of the six points, those that were read.
std::vector<PointError> point_errors(const ArguedJoint& joint) {
  std::vector<PointError> out;
  for (const Estimator point : method::hysteresis::loop_points) {
    const auto error = mass_error_percent(joint, point);
    if (error) out.push_back({point, *error});
  }
  return out;
}

Finding without_points() { return cannot_be_asked(tr("the oscillation gives no mass at A to F")); }

Finding peak_of_torque(const ArguedJoint& joint) {
  const method::gravity::CogSweepResult& precise = joint.calibration.precise;
  const method::gravity::CogSweepResult& sweep =
      precise.samples_used > 0 ? precise : joint.calibration.rough;
  if (sweep.samples_used == 0) return cannot_be_asked(tr("no sweep"));
  const double off_deg =
      std::remainder(sweep.argmax_rad - joint.scenario.load.q_peak_rad(), 2 * std::numbers::pi) *
      joint::degrees_per_rad;
  return {std::abs(off_deg) <= same_angle_deg,
          tr("{off} off", {{"off", with_unit(wording::fixed(off_deg, 3), "°")}})};
}

Finding constant_friction(const ArguedJoint& joint) {
  const auto sweeps = joint.dataset.with_role(joint::Role::rough_sweep);
  const auto& used = joint.calibration.curves.rough.used;
  if (sweeps.empty() || used.empty() || !joint.calibration.rough.constant_speed) {
    return cannot_be_asked(tr("no sweep at constant speed"));
  }
  // By means over stretches: what noise makes of single samples is no change of friction.
  constexpr std::size_t stretch = 1000;
  const joint::Recording& log = *sweeps.front();
  double least = INFINITY;
  double most = 0;
  double whole = 0;
  double stretches = 0;
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < log.size(); ++i) {
    if (!used.front()[i]) {
      sum = 0;
      count = 0;
      continue;
    }
    const double gravity_Nm =
        joint.scenario.load.torque_Nm(log.q_rad[i]) / joint.scenario.gear_ratio;
    sum += log.torque_Nm[i] - gravity_Nm;
    if (++count < stretch) continue;
    const double friction = std::abs(sum) / stretch;
    least = std::min(least, friction);
    most = std::max(most, friction);
    whole += friction;
    ++stretches;
    sum = 0;
    count = 0;
  }
  if (stretches < 2) return cannot_be_asked(tr("the sweep is too short"));
  const double change = 100 * (most - least) / (whole / stretches);
  return {change <= same_friction_percent,
          tr("it changes by {change} of itself", {{"change", percent(change)}})};
}

Finding gravity_at_B(const ArguedJoint& joint) {
  const auto error = mass_error_percent(joint, Estimator::B);
  if (!error) return without_points();
  return {std::abs(*error) <= same_mass_percent,
          tr("mass of B off by {error}", {{"error", percent(*error)}})};
}

std::optional<PointError> nearest(const std::vector<PointError>& errors) {
  const auto found = std::min_element(
      errors.begin(), errors.end(),
      [](const auto& a, const auto& b) { return std::abs(a.percent) < std::abs(b.percent); });
  if (found == errors.end()) return std::nullopt;
  return *found;
}

Finding best_point(const ArguedJoint& joint) {
  const auto best = nearest(point_errors(joint));
  if (!best) return without_points();
  return {best->point == Estimator::B,
          tr("{point}, off by {error}",
             {{"point", to_string(best->point)}, {"error", percent(best->percent)}})};
}

Finding rule_finds_it(const ArguedJoint& joint) {
  const auto best = nearest(point_errors(joint));
  if (!best) return without_points();
  const std::optional<Estimator> chosen = joint.calibration.selection.paper_rule;
  if (!chosen) return cannot_be_asked(tr("the rule chooses nothing: no curve to compare"));
  return {*chosen == best->point,
          tr("the rule takes {chosen}, the nearest is {point}",
             {{"chosen", to_string(*chosen)}, {"point", to_string(best->point)}})};
}

Finding dropping_is_better(const ArguedJoint& joint) {
  const auto rising = mass_error_percent(joint, Estimator::A);
  const auto dropping = mass_error_percent(joint, Estimator::B);
  if (!rising || !dropping) return without_points();
  return {std::abs(*dropping) < std::abs(*rising),
          tr("{dropping} dropping, {rising} rising",
             {{"dropping", percent(*dropping)}, {"rising", percent(*rising)}})};
}

Finding order_of_torques(const ArguedJoint& joint) {
  std::vector<method::hysteresis::LoopPoint> points = joint.calibration.hysteresis.points;
  if (points.empty()) return without_points();
  std::sort(points.begin(), points.end(),
            [](const auto& a, const auto& b) { return a.torque_Nm > b.torque_Nm; });
  std::string order;
  for (const auto& point : points) {
    order += (order.empty() ? "" : " > ") + to_string(point.name);
  }
  return {order == "C > F > A > B > E > D", order};
}

Finding corrected_angle(const ArguedJoint& joint) {
  const method::selection::SelectionResult& selection = joint.calibration.selection;
  if (!selection.q_c_rad || !selection.q_c_corrected_rad) {
    return cannot_be_asked(tr("no angle is corrected"));
  }
  // At gravity's trough, half a turn from the peak, the method is the same.
  const double less_deg =
      std::remainder(selection.q_c_rad->value - *selection.q_c_corrected_rad, std::numbers::pi) *
      joint::degrees_per_rad;
  return {less_deg > 0,
          tr("less by {angle}", {{"angle", with_unit(wording::significant(less_deg, 2), "°")}})};
}

Finding without_prior_knowledge(const ArguedJoint& joint) {
  const auto curve = joint.scenario.known_curve();
  if (curve == nullptr) return cannot_be_asked(tr("the simulated curve is not a law of the speed"));
  double largest = 0;
  std::size_t compared = 0;
  for (const method::viscous::ConstantSpeedRun& run : joint.calibration.viscous.runs) {
    const double truth = curve->torque_Nm(run.speed_rad_s);
    if (!std::isfinite(run.direction_difference_Nm) || truth == 0) continue;
    largest = std::max(largest, std::abs(100 * (run.direction_difference_Nm / truth - 1)));
    ++compared;
  }
  if (compared == 0) return cannot_be_asked(tr("no runs in both directions"));
  return {largest <= same_friction_percent,
          tr("off by {difference} at most", {{"difference", percent(largest)}})};
}

Finding pairs_are_unbiased(const ArguedJoint& joint) {
  std::vector<std::string> texts;
  bool holds = true;
  for (const Estimator pair : method::hysteresis::pair_means) {
    const auto error = mass_error_percent(joint, pair);
    if (!error) continue;
    holds = holds && std::abs(*error) <= same_mass_percent;
    texts.push_back(tr("{pair} {error}", {{"pair", to_string(pair)}, {"error", percent(*error)}}));
  }
  if (texts.empty()) return without_points();
  return {holds, wording::listed(texts)};
}

Finding midline_is_unbiased(const ArguedJoint& joint) {
  const auto error = mass_error_percent(joint, Estimator::midline);
  if (!error) return cannot_be_asked(tr("the oscillation gives no mid-line"));
  return {std::abs(*error) <= same_mass_percent,
          tr("mass off by {error}", {{"error", percent(*error)}})};
}

struct Hypothesis {
  bool is_ours;
  const char* where;
  const char* what;
  Finding (*ask)(const ArguedJoint& joint);
};

constexpr Hypothesis hypotheses[] = {
    {false, "3.2",
     wording::to_translate("The largest torque of the sweep lies where gravity is largest, within "
                           "0.05°"),
     peak_of_torque},
    {false, "3.2",
     wording::to_translate("In uniform motion friction takes a constant value, within 2 %"),
     constant_friction},
    {false, "3.3",
     wording::to_translate("Where z = 0 while the arm drops, gravity alone reaches the motor: the "
                           "mass is right within 0.1 %"),
     gravity_at_B},
    {false, wording::to_translate("table 2"),
     wording::to_translate("The six torques have the order of table 2"), order_of_torques},
    {false, "3.4", wording::to_translate("Of the six masses that of B is nearest to the truth"),
     best_point},
    {false, "3.4",
     wording::to_translate("The smallest error between the curves finds the nearest mass"),
     rule_finds_it},
    {false, wording::to_translate("eq. (14)"),
     wording::to_translate("The corrected angle is less than q_c"), corrected_angle},
    {false, "4",
     wording::to_translate("Gravity's torque is better read while dropping than while rising"),
     dropping_is_better},
    {false, "4",
     wording::to_translate("No prior knowledge is needed: half the difference of both directions "
                           "is the curve, within 2 %"),
     without_prior_knowledge},
    {true, "",
     wording::to_translate("Means of opposite points of the steady loop are right within "
                           "0.1 %"),
     pairs_are_unbiased},
    {true, "", wording::to_translate("The mid-line of the steady loop is right within 0.1 %"),
     midline_is_unbiased}};

}  // namespace

ArguedJoint::ArguedJoint(const simulate::Scenario& given)
    : scenario(given),
      dataset(simulate::simulated_dataset(given)),
      calibration(identify::identify(dataset)) {}

std::vector<Claim> put_claims(const ArguedJoint& papers, const ArguedJoint& other) {
  std::vector<Claim> out;
  for (const Hypothesis& one : hypotheses) {
    out.push_back({one.is_ours, tr(one.where), tr(one.what), one.ask(papers), one.ask(other)});
  }
  return out;
}

}  // namespace tribolog::paper::claims
