// Rules on friction, break-away and loops.

#include <algorithm>
#include <cmath>
#include <limits>

#include "calibration/headline.h"
#include "method/hysteresis/lugre_fit.h"
#include "method/hysteresis/position_mean.h"
#include "verdict/quantity_rooms.h"
#include "verdict/rules.h"

namespace tribolog::verdict {
namespace {

using calibration::Calibration;
using calibration::InertiaSource;
using calibration::Verdict;
using joint::Quantity;
using method::hysteresis::ContactCandidate;
using method::hysteresis::ContactComparison;
using method::hysteresis::ContactLaw;

constexpr double most_misfit_percent = 100 * method::hysteresis::lugre_misfit;

/// A model's parameter is the joint's as far as the model describes the joint: the systematic
/// residual of LuGre in the loop that it describes worst, in percent of that loop's height.
std::optional<Measured> loop_misfit(const Calibration& c) {
  const std::optional<double> share = c.lugre ? c.lugre->misfit_share() : std::nullopt;
  if (!share) return std::nullopt;
  const method::hysteresis::LuGreLoop* worst = c.lugre->worst_described();
  const double percent = 100 * *share;
  std::vector<StatedValue> values{
      {"recording", worst->recording}, {"misfit_Nm", worst->systematic_Nm}, {"percent", percent}};
  const ContactComparison& contest = c.lugre->contacts;
  if (!contest.winner || contest.winner == ContactLaw::lugre) {
    return Measured{percent, Statement::with("cause.other_contact", std::move(values))};
  }
  const ContactCandidate& found = *contest.find(*contest.winner);
  values.insert(values.end(),
                {{"stiffness_Nm_rad", found.stiffness_Nm_rad}, {"static_Nm", found.static_Nm}});
  return Measured{percent, Statement::with(contest.winner == ContactLaw::elasto_plastic
                                               ? Code{"cause.other_contact_elasto_plastic"}
                                               : Code{"cause.other_contact_maxwell_slip"},
                                           std::move(values))};
}

/// Amplitude of the smallest loop over the deflection at which the bristle slides: the larger, the
/// less of the motion is pre-sliding, and the more its course there is guessed from the rest.
std::optional<Measured> amplitude_over_deflection(const Calibration& c) {
  using method::hysteresis::LuGreParameterName;
  if (!c.lugre || !c.lugre->converged || c.hysteresis.oscillations.empty()) return std::nullopt;
  const auto stiffness = c.lugre->shown(LuGreParameterName::bristle_stiffness);
  const auto level = c.lugre->shown(LuGreParameterName::static_torque);
  if (!stiffness || !level || !(level->value > 0)) return std::nullopt;
  double smallest = std::numeric_limits<double>::infinity();
  for (const method::hysteresis::Oscillation& o : c.hysteresis.oscillations) {
    smallest = std::min(smallest, c.manifest.drive.gear_ratio() * o.amplitude_rad);
  }
  const double times = smallest * stiffness->value / level->value;
  return Measured{times, {"cause.loops_too_wide", {{"times", times}}}};
}

/// By how much the stiffness would be another with a damping that falls with speed.
std::optional<Measured> fall_of_damping(const Calibration& c) {
  if (!c.lugre || !c.lugre->converged) return std::nullopt;
  const std::optional<method::hysteresis::FallOfDamping>& fall = c.lugre->damping_fall;
  if (!fall) return Measured{0, {}};
  const double percent = 100 * fall->stiffness_share;
  return Measured{
      std::abs(percent),
      {"cause.damping_falls", {{"half_at_rad_s", fall->half_at_rad_s}, {"percent", percent}}}};
}

bool has_inertia_of(calibration::InertiaSource source, const Calibration& c) {
  return calibration::inertia_headline(c).source == source;
}

/// By how much a difference is larger than both half widths; 0 where it is not.
double certainly_apart(double difference, const statistics::Estimate& a,
                       const statistics::Estimate& b) {
  return std::max(0.0, difference - std::hypot(a.half_width(), b.half_width()));
}

/// Friction at rest of the loops.
std::optional<statistics::Estimate> rest_friction_of_loops(const Calibration& c) {
  if (!c.lugre || !c.lugre->converged) return std::nullopt;
  return c.lugre->shown(method::hysteresis::LuGreParameterName::static_torque);
}

/// Break-away torque over the least friction of the law, at speeds that were measured.
std::optional<Measured> break_away_over_sliding(const Calibration& c) {
  std::optional<statistics::Estimate> rest = c.break_away.mean_Nm;
  if (!rest) rest = rest_friction_of_loops(c);
  if (c.model.law.empty() || !rest) return std::nullopt;
  constexpr int speeds = 50;
  const std::vector<double> sliding_Nm = c.model.law.friction_Nm(c.model.law.speeds_rad_s(speeds));
  const double least_Nm = *std::min_element(sliding_Nm.begin(), sliding_Nm.end());
  if (!(least_Nm > 0)) return std::nullopt;
  const double ratio = rest->low / least_Nm;
  return Measured{ratio, {"cause.friction_taken_off", {{"ratio", ratio}}}};
}

/// How much less friction is at the speed of ramps that slid evenly than at rest, in percent of it,
/// by the dip of the curve; all of it where no curve is known.
std::optional<Measured> ramps_that_slide(const Calibration& c) {
  const double gear_ratio = c.manifest.drive.gear_ratio();
  double fastest_rad_s = 0;
  for (const method::hysteresis::BreakAwayRamp& ramp : c.break_away.ramps) {
    fastest_rad_s = std::max(fastest_rad_s, gear_ratio * ramp.even_slide_rad_s.value_or(0));
  }
  if (!c.break_away.mean_Nm || !(fastest_rad_s > 0)) return std::nullopt;
  const double rest_Nm = c.break_away.mean_Nm->value;
  const calibration::CurveHeadline curve = calibration::curve_headline(c);
  const std::optional<statistics::Estimate>& coulomb = curve.coulomb_Nm.estimate;
  const std::optional<statistics::Estimate>& dip = curve.stribeck_speed_rad_s.estimate;
  double percent = 100;
  if (coulomb && dip && dip->low > 0) {
    const double excess = std::max(0.0, 1 - coulomb->value / rest_Nm);
    percent = 100 * excess * (1 - std::exp(-std::pow(fastest_rad_s / dip->low, 2)));
  }
  return Measured{percent, {"cause.ramps_slide", {{"speed_rad_s", fastest_rad_s}}}};
}

std::optional<Measured> runs_against_ramps(const Calibration& c) {
  const std::optional<statistics::Estimate>& runs = c.model.rest_Nm;
  const std::optional<statistics::Estimate>& ramps = c.break_away.mean_Nm;
  if (!runs || !ramps) return std::nullopt;
  const double apart = certainly_apart(std::abs(runs->value - ramps->value), *runs, *ramps);
  return Measured{
      100 * apart / ramps->value,
      {"cause.runs_against_ramps", {{"runs_Nm", runs->value}, {"ramps_Nm", ramps->value}}}};
}

/// More friction at rest in the loops than the runs tell of, where ramps do not decide: a
/// controller that adds torque against friction adds less in them.
std::optional<Measured> runs_against_loops(const Calibration& c) {
  const std::optional<statistics::Estimate>& runs = c.model.rest_Nm;
  const std::optional<statistics::Estimate> loops = rest_friction_of_loops(c);
  const std::optional<statistics::Estimate>& ramps = c.break_away.mean_Nm;
  constexpr double decides = 0.1;  // half width, of the value
  const bool ramps_decide = ramps && ramps->half_width() < decides * ramps->value;
  if (!runs || !loops || ramps_decide) return std::nullopt;
  const double apart = certainly_apart(loops->value - runs->value, *runs, *loops);
  return Measured{
      100 * apart / loops->value,
      {"cause.runs_against_loops", {{"runs_Nm", runs->value}, {"loops_Nm", loops->value}}}};
}

/// Friction at rest of the loops beside that of the ramps: torques of another scale in the loops'
/// log, and a stiffness of that scale.
std::optional<Measured> loops_against_ramps(const Calibration& c) {
  const std::optional<statistics::Estimate> loops = rest_friction_of_loops(c);
  const std::optional<statistics::Estimate>& ramps = c.break_away.mean_Nm;
  if (!loops || !ramps) return std::nullopt;
  const double apart = certainly_apart(std::abs(loops->value - ramps->value), *loops, *ramps);
  return Measured{
      100 * apart / ramps->value,
      {"cause.loops_against_ramps", {{"loops_Nm", loops->value}, {"ramps_Nm", ramps->value}}}};
}

/// Ramps are read where the joint moves on, that is where it accelerates already: without the
/// inertia, that torque counts as friction. Where their resting parts show the level, as those of
/// most do on an encoder fine enough, they show this, too.
std::optional<Measured> ramps_without_inertia(const Calibration& c) {
  if (!c.break_away.mean_Nm || c.break_away.is_level) return std::nullopt;
  std::size_t broke_away = 0;
  std::size_t levels = 0;
  for (const method::hysteresis::BreakAwayRamp& ramp : c.break_away.ramps) {
    broke_away += ramp.broke_away ? 1 : 0;
    levels += ramp.level_Nm ? 1 : 0;
  }
  const bool is_unknown = has_inertia_of(InertiaSource::none, c) && 2 * levels < broke_away;
  return Measured{is_unknown ? 1.0 : 0.0, {"cause.ramps_without_inertia"}};
}

/// Whether the dip of the curve is certainly not exp(-(w/ws)^2).
bool has_another_exponent(const method::model::ModelLaw& law) {
  return law.has_dip() && law.highest_power < 2;
}

/// Largest difference of the dip from one of exponent 2, in percent of friction at rest, up to a
/// speed at which both have fallen by the same.
/// @param fall (w/ws)^exponent at that speed.
double dips_apart_percent(const method::model::ModelLaw& law, double fall) {
  constexpr int parts = 50;
  double apart = 0;
  for (int k = 1; k < parts; ++k) {
    const double share = static_cast<double>(k) / parts;  // of that speed
    apart = std::max(apart, std::abs(std::exp(-fall * std::pow(share, law.dip_power)) -
                                     std::exp(-fall * share * share)));
  }
  return 100 * apart * law.excess_Nm / (law.level_Nm + law.excess_Nm);
}

/// Of the curve: down to a third of the dip, at the Stribeck velocity of both.
std::optional<Measured> stribeck_exponent(const Calibration& c) {
  const method::model::ModelLaw& law = c.model.law;
  if (!law.has_dip()) return std::nullopt;
  if (!has_another_exponent(law)) return Measured{0, {}};
  return Measured{dips_apart_percent(law, 1),
                  {"cause.stribeck_exponent", {{"exponent", law.dip_power}}}};
}

/// Up to the loops' fastest speed, whose model has the exponent 2.
std::optional<Measured> stribeck_exponent_in_loops(const Calibration& c) {
  const method::model::ModelLaw& law = c.model.law;
  if (!law.has_dip() || !c.lugre || !c.lugre->converged) return std::nullopt;
  if (!has_another_exponent(law)) return Measured{0, {}};
  const double fall = std::pow(c.lugre->peak_speed_rad_s / law.dip_rad_s, law.dip_power);
  const double percent = dips_apart_percent(law, fall);
  return Measured{
      percent,
      {"cause.stribeck_exponent_in_loops", {{"exponent", law.dip_power}, {"percent", percent}}}};
}

/// How many speeds the runs lack of five, as many as the law with a dip has parameters: with fewer
/// any dip goes through all of them, and nothing shows that it is of another form.
std::optional<Measured> missing_run_speeds(const Calibration& c) {
  const method::checks::DataCheck* const check =
      c.data_checks.find(method::checks::CheckName::run_speeds);
  if (check == nullptr || !check->measured || !check->at_least) return std::nullopt;
  return Measured{*check->at_least - *check->measured,
                  {"cause.few_run_speeds", {{"speeds", std::lround(*check->measured)}}}};
}

std::optional<Measured> stribeck_exponent_without_ramps(const Calibration& c) {
  return c.break_away.mean_Nm ? std::nullopt : stribeck_exponent_in_loops(c);
}

/// Misfit of the loops where the break-away torque comes from them, for want of ramps.
std::optional<Measured> loop_misfit_without_ramps(const Calibration& c) {
  return c.break_away.mean_Nm ? std::nullopt : loop_misfit(c);
}

/// Misfit of the loops where the friction over the speed comes from them, for want of runs.
std::optional<Measured> loop_misfit_without_runs(const Calibration& c) {
  const bool is_of_loops =
      calibration::curve_headline(c).source == calibration::HeadlineSource::loops;
  return is_of_loops ? loop_misfit(c) : std::nullopt;
}

/// Five times the dip's speed over the fastest of the loops, where friction over the speed comes
/// from them: below it they hardly leave the dip.
std::optional<Measured> loops_within_dip(const Calibration& c) {
  const calibration::CurveHeadline headline = calibration::curve_headline(c);
  if (headline.source != calibration::HeadlineSource::loops) return std::nullopt;
  const std::optional<statistics::Estimate>& dip = headline.stribeck_speed_rad_s.estimate;
  constexpr double beyond = 5;
  const double fastest = c.lugre->peak_speed_rad_s;
  return Measured{dip ? beyond * dip->value / fastest : beyond,
                  {"cause.loops_within_dip", {{"fastest_rad_s", fastest}}}};
}

/// Samples of the torque that were replaced, of the recording with most of them.
std::optional<Measured> torque_outliers(const Calibration& c) {
  const method::motion::TorqueOutliers& found = c.torque_outliers;
  return Measured{found.worst_percent,
                  {"cause.outliers",
                   {{"samples", found.replaced},
                    {"percent", found.worst_percent},
                    {"recording", found.recording},
                    {"largest_Nm", found.largest_Nm}}}};
}

/// Scatter of stamps that are not those of the sampling, of the recording where it is largest.
std::optional<Measured> false_stamps(const Calibration& c) {
  const method::motion::FalseStamps& found = c.false_stamps;
  return Measured{found.worst_percent,
                  {"cause.false_stamps",
                   {{"recording", found.recording},
                    {"percent", found.worst_percent},
                    {"interval_ms", 1e3 * found.interval_s}}}};
}

// Friction by the motor's angle: in the intervals of what loops and ramps show.

/// Amplitude of a sine with the standard deviation that the sweep shows.
std::optional<Measured> by_motor_angle(const Calibration& c) {
  if (!c.rough.found || !c.rough.both_directions || !c.rough.coulomb_Nm) return std::nullopt;
  const double percent =
      100 * std::sqrt(2.0) * c.rough.friction_by_angle_Nm / std::abs(c.rough.coulomb_Nm->value);
  // Fewer periods along the whole sweep are a course of the joint's angle, or of the load.
  const std::vector<method::gravity::RippleLine> lines =
      method::hysteresis::of_motor_turn(c.rough, c.manifest.drive.gear_ratio())
          .friction_of_angle.lines;
  if (lines.empty()) {
    return Measured{percent, {"cause.friction_along_angle", {{"percent", percent}}}};
  }
  return Measured{percent,
                  {"cause.friction_by_motor_angle",
                   {{"percent", percent}, {"periods", lines.front().periods_per_turn}}}};
}

std::optional<Measured> between_ramps(const Calibration& c) {
  const method::hysteresis::BreakAwayResult& ramps = c.break_away;
  if (ramps.positions < 2) return std::nullopt;
  const double percent = 100 * ramps.between_positions;
  return Measured{percent,
                  {"cause.friction_by_motor_angle_of_ramps",
                   {{"percent", percent}, {"positions", ramps.positions}}}};
}

}  // namespace

std::vector<Rule> friction_rules() {
  const auto reported = Verdict::usable;  // and corrected, or in the interval
  const auto doubtful = Verdict::doubtful;
  const auto unknown = Verdict::not_identifiable;
  const Quantities everything = of_gravity + of_loops + of_friction;
  return {
      {{"runs_against_ramps", "%", 2, runs_against_ramps},
       doubtful,
       of_curve,
       of_curve,
       "record.torque_measured"},
      {{"runs_against_ramps_at_rest", "%", 2, runs_against_ramps},
       doubtful,
       of_break_away,
       none,
       "record.torque_measured"},
      // No dry or greased contact of a joint sticks so much more than it slides.
      {{"break_away_over_sliding", "", 3, break_away_over_sliding},
       doubtful,
       of_curve,
       of_curve,
       "record.torque_measured"},
      // Of loops alone it is no better known than to some percent, where their contact is not
      // LuGre's.
      {{"runs_against_loops", "%", 10, runs_against_loops},
       doubtful,
       of_curve,
       of_curve,
       "record.ramps"},
      {{"loops_against_ramps", "%", 4, loops_against_ramps},
       doubtful,
       of_loops,
       none,
       "record.torque_measured"},
      {{"ramps_that_slide", "%", 1, ramps_that_slide},
       doubtful,
       of_break_away,
       none,
       "record.ramps"},
      {{"inertia_at_break_away", "", 0, ramps_without_inertia},
       doubtful,
       of_break_away,
       none,
       "record.slower_starts"},
      {{"friction_by_motor_angle", "%", 1, by_motor_angle}, reported, none, none, {}},
      {{"break_away_by_motor_angle", "%", 1, between_ramps}, reported, none, none, {}},
      {{"stribeck_exponent", "%", 0.5, stribeck_exponent}, reported, none, none, {}},
      // At three speeds 8 of 26 usable Stribeck velocities were wrong (study --less-data,
      // sweep_and_three_runs).
      {{"missing_run_speeds", "", 0, missing_run_speeds},
       doubtful,
       {Quantity::stribeck_speed},
       none,
       "record.runs"},
      // A shape that is off by this bends stiffness by a tenth and damping by half of what matters
      // (study --misfit, disturbance stribeck_power).
      {{"stribeck_exponent_in_loops", "%", 4, stribeck_exponent_in_loops},
       doubtful,
       of_loops,
       none,
       "record.compare_reversals"},
      {{"stribeck_exponent_at_break_away", "%", 2.5, stribeck_exponent_without_ramps},
       doubtful,
       of_break_away,
       none,
       "record.ramps"},
      // Replaced by the clock of the sampling, which leaves nothing to doubt.
      {{"false_stamps", "%", 0, false_stamps}, reported, none, none, "clock.log_time_of_sampling"},
      {{"torque_outliers", "%", 0, torque_outliers},
       reported,
       none,
       none,
       "record.more_of_the_same"},
      {{"many_torque_outliers", "%", 2, torque_outliers},
       doubtful,
       everything,
       everything,
       "record.more_of_the_same"},
      {{"loop_misfit", "%", most_misfit_percent, loop_misfit},
       doubtful,
       of_loops,
       none,
       "record.compare_reversals"},
      // Behind a servo that gives way the motion in pre-sliding is not that of the rest: at 600
      // times the stiffness was 12 % too large with nothing else to show it.
      {{"amplitude_over_deflection", "", 300, amplitude_over_deflection},
       doubtful,
       of_loops,
       none,
       "record.oscillation"},
      // A term that is there beyond doubt, at the smallest shift that is worth a word.
      {{"fall_of_damping", "%", 0.5, fall_of_damping},
       doubtful,
       of_loops,
       none,
       "record.compare_reversals"},
      {{"loop_misfit_at_break_away", "%", most_misfit_percent, loop_misfit_without_ramps},
       doubtful,
       of_break_away,
       none,
       "record.ramps"},
      {{"loop_misfit_of_friction", "%", most_misfit_percent, loop_misfit_without_runs},
       doubtful,
       of_law,
       none,
       "record.runs"},
      {{"loops_within_dip", "", 1, loops_within_dip}, doubtful, of_law, none, "record.runs"},
      {{"loop_unlike_model", "%", 10, loop_misfit},
       unknown,
       of_loops,
       none,
       "record.compare_reversals"},
  };
}

}  // namespace tribolog::verdict
