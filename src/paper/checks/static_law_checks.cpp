// Equations (1), (2), (6) and (7): friction as a function of speed.

#include <numbers>
#include <string>
#include <utility>

#include "paper/checks/check.h"
#include "paper/drawings/printed_paper.h"
#include "wording/tr.h"

namespace tribolog::paper::checks {
namespace {

using wording::tr;

constexpr double slowest_rad_s = 1e-6;
constexpr double fastest_rad_s = 300;

double sign(double x) { return x < 0 ? -1.0 : 1.0; }

std::vector<double> law_grid() { return speeds_of_both_signs(slowest_rad_s, fastest_rad_s); }

template <class Law>
Check is_odd(const Law& law) {
  return vanishing(
      tr("Odd in ω: largest |T_f(ω) + T_f(−ω)|"),
      largest_over(law_grid(), [&](double w) { return law.torque_Nm(w) + law.torque_Nm(-w); }), 0,
      "N·m", "");
}

template <class Law>
Check dissipates(const Law& law) {
  double least = 0;
  for (const double w : law_grid()) least = std::min(least, law.torque_Nm(w) * w);
  return vanishing(tr("Friction dissipates power: smallest T_f ω, if negative"), least, 0, "W", "");
}

}  // namespace

Checks check_equation_1(const PapersJoint& joint) {
  const friction::StribeckFriction& law = joint.laws.discontinuous;
  const friction::StribeckCurve::Parameters& p = law.curve().parameters();
  const double viscous = law.parameters().viscous_Nms_rad;
  const double broken = p.static_Nm;
  const auto printed = [&](double w) {
    const double fall = std::exp(-(w / p.stribeck_speed_rad_s) * (w / p.stribeck_speed_rad_s));
    return (p.coulomb_Nm + (broken - p.coulomb_Nm) * fall + viscous * std::abs(w)) * sign(w);
  };
  return {
      vanishing(tr("Equation against the program, at 1000 speeds: largest difference"),
                largest_over(law_grid(), [&](double w) { return law.torque_Nm(w) - printed(w); }),
                law_rounding_Nm, "N·m", tr(law_rounding)),
      other_way(tr("Jump at rest, from −T_brk to T_brk"), 2 * broken,
                law.torque_Nm(slowest_rad_s) - law.torque_Nm(-slowest_rad_s), 1e-7, "N·m",
                tr("read at ±10⁻⁶ rad/s")),
      other_way(tr("At rest, pushed with twice T_brk, friction holds"), broken,
                law.torque_at_rest_Nm(2 * broken), 0, "N·m", ""),
      is_odd(law), dissipates(law)};
}

Checks check_equation_2(const PapersJoint& joint) {
  const friction::ThresholdSpeedFriction& law = joint.laws.continuous;
  const friction::ThresholdSpeedFriction::Parameters& p = law.parameters();
  const double threshold = p.threshold_rad_s;
  const auto sliding = [&](double w) {
    return (p.coulomb_Nm +
            (p.static_Nm - p.coulomb_Nm) * std::exp(-p.stribeck_decay_s_rad * std::abs(w))) *
               sign(w) +
           p.viscous_Nms_rad * w;
  };
  const auto meant = [&](double w) {
    return std::abs(w) >= threshold ? sliding(w) : w * sliding(threshold) / threshold;
  };
  const double below = std::nextafter(threshold, 0.0);
  return {
      vanishing(tr("Equation against the program, at 1000 speeds: largest difference"),
                largest_over(law_grid(), [&](double w) { return law.torque_Nm(w) - meant(w); }),
                law_rounding_Nm, "N·m", tr(law_rounding)),
      vanishing(tr("The branches meet: jump at ω_th"),
                law.torque_Nm(threshold) - law.torque_Nm(below), law_rounding_Nm, "N·m",
                tr(law_rounding)),
      other_way(tr("Below ω_th friction is proportional to ω: T_f at half of ω_th, by T_f at ω_th"),
                0.5, law.torque_Nm(threshold / 2) / law.torque_Nm(threshold), law_rounding_Nm, "",
                tr(law_rounding)),
      printed_value(tr("“The coefficient of the proportionality is the quotient of the static "
                       "friction and threshold velocity”: the slope at rest by that quotient"),
                    1, 0, law.torque_Nm(threshold / 2) / (threshold / 2) * threshold / p.static_Nm,
                    drawings::largest_threshold_rad_s, "",
                    tr("by so much friction may have fallen at the largest threshold printed")),
      vanishing(tr("It does not hold at rest: T_f(0)"), law.torque_Nm(0), 0, "N·m", ""),
      is_odd(law),
      dissipates(law)};
}

Checks check_equation_6(const PapersJoint& joint) {
  const friction::WaiboerFriction& law = sliding_of(joint.scenario);
  const friction::WaiboerFriction::Parameters& p = law.parameters();
  const auto meant = [&](double w) {
    return p.asperity_torque_Nm *
               std::exp(-std::pow(w / p.stribeck_speed_rad_s, p.stribeck_power)) +
           p.viscous_coefficient * std::pow(w, 1 - p.viscous_power);
  };
  Checks out{vanishing(tr("Equation against the program, at 500 speeds: largest difference"),
                       largest_over(law_grid(),
                                    [&](double w) {
                                      const double size = std::abs(w);
                                      return law.magnitude_Nm(size) - meant(size);
                                    }),
                       law_rounding_Nm, "N·m", tr(law_rounding)),
             other_way(tr("At rest friction is T_a"), p.asperity_torque_Nm, law.magnitude_Nm(0), 0,
                       "N·m", "")};
  const auto& fit = joint.calibration.friction.waiboer;
  if (fit) {
    constexpr double share = 1e-3;
    const std::string why = tr("a thousandth: 40 runs of a log without noise");
    const auto symbol = [](const char* name) {
      return tr("Found again from the simulated runs: {symbol}", {{"symbol", name}});
    };
    const auto found = [&](std::string what, double truth, const statistics::Estimate& ours,
                           const char* unit) {
      out.push_back(other_way(std::move(what), truth, ours.value, share * truth, unit, why));
    };
    found(symbol("T_a"), p.asperity_torque_Nm, fit->asperity_torque_Nm, "N·m");
    found(symbol("ω_s"), p.stribeck_speed_rad_s, fit->stribeck_speed_rad_s, "rad/s");
    found(symbol("δ_a"), p.stribeck_power, fit->stribeck_power, "");
    found(tr("Found again from the simulated runs: c_v, the viscous part at 1 rad/s"),
          p.viscous_coefficient, fit->viscous_coefficient, "N·m");
    found(symbol("δ_v"), p.viscous_power, fit->viscous_power, "");
  }
  return out;
}

Checks check_equation_7(const PapersJoint& joint) {
  const friction::WaiboerFriction& law = sliding_of(joint.scenario);
  const double c = law.parameters().smoothing_s_rad;
  const auto meant = [&](double w) {
    return 2 / std::numbers::pi * std::atan(c * w) * law.magnitude_Nm(std::abs(w));
  };
  const double turn = drawings::direction_change_rad_s;
  return {vanishing(tr("Equation against the program, at 1000 speeds: largest difference"),
                    largest_over(law_grid(), [&](double w) { return law.torque_Nm(w) - meant(w); }),
                    law_rounding_Nm, "N·m", tr(law_rounding)),
          printed_value(
              tr("The direction has changed within ±10⁻⁴ rad/s: share of eq. (6) there"), 1, 0,
              law.torque_Nm(turn) / law.magnitude_Nm(turn),
              2 / (std::numbers::pi * drawings::smoothing_s_rad * turn), "",
              tr("2/(π c ω) with the printed c = 10⁶: so far is the inverse tangent from its end")),
          vanishing(tr("Continuous through rest: T_f(0)"), law.torque_Nm(0), 0, "N·m", ""),
          is_odd(law), dissipates(law)};
}

}  // namespace tribolog::paper::checks
