#include "paper/checks/golden_numbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "base/requirements.h"
#include "joint/degrees.h"
#include "paper/checks/papers_joint.h"
#include "paper/drawings/printed_paper.h"
#include "paper/scenes/scene_words.h"
#include "wording/tr.h"

namespace tribolog::paper::checks {

// The loop's six torques in closed form, for the joint without inertia and Stribeck effect.
//
// With g constant, eq. (4) is linear along the way: between reversals z goes to ±g like
// exp(-way/g). The points follow without a solver and without samples.

namespace {

using wording::tr;

/// Torques at the motor [N·m] of A, B, C, D, E, F in the first turn, from z = 0 at q_peak.
std::array<double, 6> plain_loop_torques_Nm(const simulate::Scenario& scenario) {
  const friction::LuGreFriction::Parameters& p = bristles_of(scenario).parameters();
  const simulate::OscillationExperiment& e = present(scenario.oscillation);
  const double g = p.static_Nm / p.bristle_stiffness_Nm_rad;
  const double swing = scenario.gear_ratio * e.amplitude_rad;
  const double top_speed = 2 * std::numbers::pi * e.frequency_Hz * swing;
  const double gravity_Nm = scenario.load.amplitude_Nm() / scenario.gear_ratio;

  // `way` from the middle of the swing, upwards, or from the reversal before.
  const auto torque = [&](double angle, double speed, double z) {
    const double rate = speed - std::abs(speed) * z / g;
    return gravity_Nm * std::cos(angle / scenario.gear_ratio) + p.bristle_stiffness_Nm_rad * z +
           p.bristle_damping_Nms_rad * rate + p.viscous_Nms_rad * speed;
  };
  const auto speed_after = [&](double way) {
    const double angle = swing - way;
    return top_speed * std::sqrt(1 - angle * angle / (swing * swing));
  };
  const double z_C = g * (1 - std::exp(-swing / g));
  const auto dropping = [&](double way) {
    return torque(swing - way, -speed_after(way), -g + (z_C + g) * std::exp(-way / g));
  };
  const double z_D = -g + (z_C + g) * std::exp(-2 * swing / g);
  const auto rising = [&](double way) {
    return torque(way - swing, speed_after(way), g - (g - z_D) * std::exp(-way / g));
  };
  const double way_B = g * std::log((z_C + g) / g);
  // |dz/dt| ~ sqrt(2u - u²) exp(-N u) is largest where N u² - (2N + 1) u + 1 = 0; u: way/swing.
  const double N = swing / g;
  const double half = (2 * N + 1) / (2 * N);
  const double way_F = swing * (half - std::sqrt(half * half - 1 / N));
  return {torque(0, top_speed, 0), dropping(way_B), torque(swing, 0, z_C),
          torque(-swing, 0, z_D),  rising(way_F),   dropping(way_F)};
}

constexpr double half_last_place_Nm = 5e-6;  ///< Of torques given to five decimals.

void add_table_2(Checks& out) {
  for (const drawings::TorqueRow& row : drawings::table_2) {
    out.push_back(printed_value(
        tr("Table 2, mass from the printed T at {point}", {{"point", std::string(1, row.point)}}),
        row.mass_kg, 3, drawings::mass_of_torque_kg(row.torque_Nm), drawings::rounding_kg(), "kg",
        tr("0.0005 n/(g r) + 0.0005: rounding of torque and mass")));
  }
}

void add_ratios(const PapersJoint& joint, Checks& out) {
  const simulate::Scenario& s = joint.scenario;
  const friction::LuGreFriction::Parameters& p = bristles_of(s).parameters();
  const simulate::OscillationExperiment& e = present(s.oscillation);
  const double swing = s.gear_ratio * e.amplitude_rad;
  const double swing_speed = swing * 2 * std::numbers::pi * e.frequency_Hz;
  const std::string digits = tr("digits of the scenario's parameters");
  out.push_back(reconstructed_value(tr("G/n, gravity torque at the motor"), 3.88318571, 8,
                                    joint.true_gravity_Nm(), 5e-9, "N·m", digits));
  out.push_back(
      reconstructed_value(tr("True surrogate mass at 0.5 m"), 79.1679, 4,
                          present(scenes::stated_numbers(joint.robot).surrogate_mass_kg).value,
                          5e-5, "kg", tr("digits of the method's number")));
  out.push_back(reconstructed_value("T_s", 0.88437633, 8, p.static_Nm, 5e-9, "N·m", digits));
  out.push_back(reconstructed_value("σ₀ n a / T_s", 5.26269819, 8,
                                    p.bristle_stiffness_Nm_rad * swing / p.static_Nm, 1e-4, "",
                                    tr("σ₀ is given to five digits")));
  out.push_back(reconstructed_value("(σ₁ + σ₂) n a 2π f", 0.04849331, 8,
                                    (p.bristle_damping_Nms_rad + p.viscous_Nms_rad) * swing_speed,
                                    1e-6, "N·m", tr("σ₁ is given to five digits")));
}

constexpr auto names = method::hysteresis::loop_points;
constexpr double plain[] = {3.93168, 3.86161, 4.76298, 2.99886, 3.69575, 4.06881};
constexpr double whole[] = {3.93168, 3.85868, 4.76230, 2.99954, 3.69472, 4.06883};

/// How fast torque changes where a point is read [N·m/s].
double torque_rate(const PapersJoint& joint, Estimator name) {
  const method::hysteresis::LoopTrace& trace = joint.calibration.curves.loops.at(0);
  const double t = joint.point(name).t_s;
  const double dt = trace.t_s.at(1) - trace.t_s.at(0);
  const auto i = static_cast<std::size_t>(t / dt);
  return std::abs(trace.torque_Nm.at(i + 1) - trace.torque_Nm.at(i)) / dt;
}

/// Where torque moves fast, an instant read late by `late_s` shows.
Check given_torque(const PapersJoint& joint, Estimator name, std::string what, double given,
                   double ours, double late_s) {
  const double rate_Nm_s = torque_rate(joint, name);
  return reconstructed_value(std::move(what), given, 5, ours,
                             half_last_place_Nm + late_s * rate_Nm_s, "N·m",
                             tr("half the last digit, and {late_ms:g} ms of reading where T "
                                "changes by {rate_Nm_s:.2g} N·m/s",
                                {{"late_ms", late_s * 1e3}, {"rate_Nm_s", rate_Nm_s}}));
}

void add_torques(const PapersJoint& joint, Checks& out) {
  const std::array<double, 6> closed_form = plain_loop_torques_Nm(joint.scenario);
  constexpr double grid_s = 2e-4;  // what the given numbers without inertia were read with
  constexpr double fine_s = 1e-5;
  constexpr double between_samples_s = 5e-6;
  const auto plain_ours = [&](Estimator name) {
    for (const method::hysteresis::LoopPoint& p : joint.plain_points) {
      if (p.name == name) return p.torque_Nm;
    }
    return std::nan("");
  };
  for (std::size_t i = 0; i < std::size(names); ++i) {
    out.push_back(law_value(tr("T at {point} without inertia and Stribeck effect, in closed form",
                               {{"point", to_string(names[i])}}),
                            closed_form[i], plain_ours(names[i]),
                            half_last_place_Nm + between_samples_s * torque_rate(joint, names[i]),
                            "N·m", tr("0.005 ms of reading between samples 1 ms apart")));
  }
  for (std::size_t i = 0; i < std::size(names); ++i) {
    out.push_back(given_torque(
        joint, names[i], tr("T at {point}, the same as given", {{"point", to_string(names[i])}}),
        plain[i], plain_ours(names[i]), grid_s));
  }
  for (std::size_t i = 0; i < std::size(names); ++i) {
    out.push_back(given_torque(
        joint, names[i],
        tr("T at {point} with both included, as given", {{"point", to_string(names[i])}}), whole[i],
        joint.point(names[i]).torque_Nm, fine_s));
  }
}

/// Largest deviation [%] of six torques, in the order A to F, from table 2's.
template <class Torques>
double largest_from_table_2(const Torques& torques) {
  double largest = 0;
  for (std::size_t i = 0; i < std::size(names); ++i) {
    largest = std::max(largest, 100 * std::abs(torques[i] / drawings::table_2.at(i).torque_Nm - 1));
  }
  return largest;
}

void add_deviations(const PapersJoint& joint, Checks& out) {
  std::array<double, 6> ours{};
  for (std::size_t i = 0; i < std::size(names); ++i) ours[i] = joint.point(names[i]).torque_Nm;
  const std::string stated = tr("as stated, within 0.24 %, rounded");
  constexpr double stated_percent = 0.245;
  out.push_back(
      vanishing(tr("Table 2 against the torques given without inertia and Stribeck effect: "
                   "largest deviation"),
                largest_from_table_2(plain), 0.20, "%", tr("as stated, within 0.20 %")));
  out.push_back(vanishing(tr("The same against their closed form"),
                          largest_from_table_2(plain_loop_torques_Nm(joint.scenario)),
                          stated_percent, "%",
                          tr("0.20 % holds for the torques as given, whose E is read late")));
  out.push_back(vanishing(tr("Table 2 against the torques given with both included"),
                          largest_from_table_2(whole), stated_percent, "%", stated));
  out.push_back(vanishing(tr("The same against our torques"), largest_from_table_2(ours),
                          stated_percent, "%", stated));
}

void add_pairs(const PapersJoint& joint, Checks& out) {
  const double truth = joint.true_mass_kg();
  const auto mass = [&](Estimator estimator) {
    const method::hysteresis::SurrogateMass* found = joint.calibration.masses.find(estimator);
    return found != nullptr ? found->mass_kg.value : NAN;
  };
  for (const Estimator pair : method::hysteresis::pair_means) {
    const auto [first, second] = present(points_of_pair(pair));
    out.push_back(
        law_value(tr("Pair mean ({first} + {second})/2 of the steady loop is free of bias",
                     {{"first", to_string(first)}, {"second", to_string(second)}}),
                  truth, mass(pair), 1e-4 * truth, "kg", tr("what the program promises")));
  }
  out.push_back(law_value(tr("The mid-line of the whole loop is free of bias"), truth,
                          mass(Estimator::midline), 1e-4 * truth, "kg",
                          tr("what the program promises")));
  out.push_back(by_name(tr("The paper's rule selects"), Origin::printed, "B",
                        to_string(joint.calibration.selection.paper_rule)));
}

void add_angles(const PapersJoint& joint, Checks& out) {
  out.push_back(printed_value("q_peak", -drawings::precise_angle_deg, 5,
                              present(joint.calibration.q_peak_rad).value * joint::degrees_per_rad,
                              1e-5, "°", tr("the last printed place")));
  out.push_back(reconstructed_value("q_c = −q_peak", 0.388019, 6,
                                    present(joint.calibration.selection.q_c_rad).value, 1e-6, "rad",
                                    tr("the last digit")));
}

void add_friction_curve(const PapersJoint& joint, Checks& out) {
  const friction::WaiboerFriction& law = sliding_of(joint.scenario);
  double dip_Nm = INFINITY;
  double dip_rad_s = 0;
  for (double w = 1; w <= 100; w += 0.01) {
    if (law.magnitude_Nm(w) >= dip_Nm) continue;
    dip_Nm = law.magnitude_Nm(w);
    dip_rad_s = w;
  }
  const std::string two = tr("given to two decimals");
  out.push_back(reconstructed_value(tr("Friction curve at rest"), 0.88, 2, law.magnitude_Nm(0),
                                    0.005, "N·m", two));
  out.push_back(reconstructed_value(tr("at its dip"), 0.45, 2, dip_Nm, 0.01, "N·m",
                                    tr("“0.45 near 15 to 25 rad/s”")));
  out.push_back(reconstructed_value(tr("speed of the dip, “near 15 to 25 rad/s”"), 20, 0, dip_rad_s,
                                    5, "rad/s", tr("the range given")));
  out.push_back(
      reconstructed_value(tr("at 300 rad/s"), 1.17, 2, law.magnitude_Nm(300), 0.005, "N·m", two));
}

}  // namespace

Checks golden_numbers(const PapersJoint& joint) {
  Checks out;
  add_table_2(out);
  add_ratios(joint, out);
  add_torques(joint, out);
  add_deviations(joint, out);
  add_pairs(joint, out);
  add_angles(joint, out);
  add_friction_curve(joint, out);
  const Checks parameters = golden_parameters(joint);
  out.insert(out.end(), parameters.begin(), parameters.end());
  return out;
}

// The reconstructed joint's parameters and experiments as the method gives them, against the
// scenario that is simulated.

namespace {

/// One that is known by its symbol.
std::string parameter(const char* symbol) { return tr("Scenario: {symbol}", {{"symbol", symbol}}); }

class Given {
 public:
  /// Half the last digit may be rounding.
  void add(std::string what, double given, int places, double ours, const char* unit) {
    out.push_back(reconstructed_value(std::move(what), given, places, ours,
                                      0.5 * std::pow(10.0, -places), unit,
                                      tr("half the last digit given")));
  }
  Checks out;
};

void add_joint(const simulate::Scenario& s, Given& given) {
  const friction::LuGreFriction::Parameters& p = bristles_of(s).parameters();
  given.add(parameter("σ₀"), 465.42, 2, p.bristle_stiffness_Nm_rad, "N·m/rad");
  given.add(parameter("σ₁"), 0.77080, 5, p.bristle_damping_Nms_rad, "N·m·s/rad");
  given.add(parameter("σ₂"), 0.001, 3, p.viscous_Nms_rad, "N·m·s/rad");
  given.add(parameter("T_c"), 0.60, 2, p.coulomb_Nm, "N·m");
  given.add(tr("Scenario: ω_s of the bristles"), 5, 0, p.stribeck_speed_rad_s, "rad/s");
  given.add(tr("Scenario: J of motor and gear"), 1e-4, 4, s.motor_inertia_kgm2, "kg·m²");
  given.add(parameter("m"), 98.96, 2, s.load.mass_kg(), "kg");
  given.add(parameter("r"), 0.4, 1, s.load.distance_m(), "m");
  const simulate::OscillationExperiment& e = present(s.oscillation);
  given.add(tr("Scenario: swing of the motor, n a"), 0.01, 2, s.gear_ratio * e.amplitude_rad,
            "rad");
  given.add(parameter("f"), 1, 0, e.frequency_Hz, "Hz");
}

void add_sliding(const simulate::Scenario& s, Given& given) {
  const friction::WaiboerFriction::Parameters& p = sliding_of(s).parameters();
  given.add(tr("Scenario: T_a of eq. (6)"), 0.8844, 4, p.asperity_torque_Nm, "N·m");
  given.add(tr("Scenario: ω_s of eq. (6)"), 5, 0, p.stribeck_speed_rad_s, "rad/s");
  given.add(parameter("δ_a"), 0.7, 1, p.stribeck_power, "");
  given.add(tr("Scenario: c_v, the viscous part at 1 rad/s"), 0.12, 2, p.viscous_coefficient,
            "N·m");
  given.add(parameter("δ_v"), 0.6, 1, p.viscous_power, "");
  given.add(tr("Scenario: c of eq. (7)"), drawings::smoothing_s_rad, 0, p.smoothing_s_rad, "s/rad");
}

void add_experiments(const simulate::Scenario& s, Given& given) {
  const simulate::SweepExperiment& sweep = present(s.rough_sweep);
  given.add(tr("Scenario: rough sweep from"), -80, 0, sweep.from_rad * joint::degrees_per_rad, "°");
  given.add(tr("Scenario: rough sweep to"), 60, 0, sweep.to_rad * joint::degrees_per_rad, "°");
  given.add(tr("Scenario: speed of the rough sweep"), 2, 0,
            sweep.speed_rad_s * joint::degrees_per_rad, "°/s");
  const simulate::ConstantSpeedExperiment& runs = present(s.constant_speed);
  const auto& speeds = runs.motor_speeds_rad_s;
  const auto [slowest, fastest] = std::minmax_element(speeds.begin(), speeds.end());
  given.add(tr("Scenario: number of constant speeds, in both directions"), 20, 0,
            runs.both_directions ? static_cast<double>(speeds.size()) : NAN, "");
  given.add(tr("Scenario: slowest of them"), 1, 0, *slowest, "rad/s");
  given.add(tr("Scenario: fastest of them"), 300, 0, *fastest, "rad/s");
}

}  // namespace

Checks golden_parameters(const PapersJoint& joint) {
  Given given;
  add_joint(joint.scenario, given);
  add_sliding(joint.scenario, given);
  add_experiments(joint.scenario, given);
  return given.out;
}

}  // namespace tribolog::paper::checks
