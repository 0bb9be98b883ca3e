#include "paper/checks/golden_numbers.h"

#include <algorithm>
#include <array>
#include <numbers>

#include <fmt/format.h>

#include "base/present.h"
#include "joint/degrees.h"
#include "paper/checks/plain_loop.h"
#include "paper/drawings/printed_paper.h"
#include "paper/scenes/test_numbers.h"

namespace tribolog::paper {
namespace {

constexpr double half_last_place_Nm = 5e-6;  ///< Of torques given to five decimals.

void add_table_2(Checks& out) {
  for (const printed::TorqueRow& row : printed::table_2) {
    out.push_back(printed_value(std::string("Table 2, mass from the printed T at ") + row.point,
                                row.mass_kg, 3, printed::mass_of_torque_kg(row.torque_Nm),
                                printed::rounding_kg(), "kg",
                                "0.0005 n/(g r) + 0.0005: rounding of torque and mass"));
  }
}

void add_ratios(const PapersJoint& joint, Checks& out) {
  const Scenario& s = joint.scenario;
  const LuGreFriction::Parameters& p = bristles_of(s).parameters();
  const OscillationExperiment& e = present(s.oscillation);
  const double swing = s.gear_ratio * e.amplitude_rad;
  const double swing_speed = swing * 2 * std::numbers::pi * e.frequency_Hz;
  const char* digits = "digits of the scenario's parameters";
  out.push_back(reconstructed_value("G/n, gravity torque at the motor", 3.88318571, 8,
                                    joint.true_gravity_Nm(), 5e-9, "N·m", digits));
  out.push_back(
      reconstructed_value("True surrogate mass at 0.5 m", 79.1679, 4,
                          present(scenes::stated_numbers(joint.robot).surrogate_mass_kg).value,
                          5e-5, "kg", "digits of the method's number"));
  out.push_back(reconstructed_value("T_s", 0.88437633, 8, p.static_Nm, 5e-9, "N·m", digits));
  out.push_back(reconstructed_value("σ₀ n a / T_s", 5.26269819, 8,
                                    p.bristle_stiffness_Nm_rad * swing / p.static_Nm, 1e-4, "",
                                    "σ₀ is given to five digits"));
  out.push_back(reconstructed_value("(σ₁ + σ₂) n a 2π f", 0.04849331, 8,
                                    (p.bristle_damping_Nms_rad + p.viscous_Nms_rad) * swing_speed,
                                    1e-6, "N·m", "σ₁ is given to five digits"));
}

constexpr char names[] = {'A', 'B', 'C', 'D', 'E', 'F'};
constexpr double plain[] = {3.93168, 3.86161, 4.76298, 2.99886, 3.69575, 4.06881};
constexpr double whole[] = {3.93168, 3.85868, 4.76230, 2.99954, 3.69472, 4.06883};

/// How fast torque changes where a point is read [N·m/s].
double torque_rate(const PapersJoint& joint, char name) {
  const LoopTrace& trace = joint.calibration.hysteresis.traces.at(0);
  const double t = joint.point(name).t_s;
  const double dt = trace.t_s.at(1) - trace.t_s.at(0);
  const auto i = static_cast<std::size_t>(t / dt);
  return std::abs(trace.torque_Nm.at(i + 1) - trace.torque_Nm.at(i)) / dt;
}

/// Where torque moves fast, an instant read late by `late_s` shows.
Check given_torque(const PapersJoint& joint, char name, const char* which, double given,
                   double ours, double late_s) {
  const double bound = half_last_place_Nm + late_s * torque_rate(joint, name);
  return reconstructed_value(
      std::string("T at ") + name + which, given, 5, ours, bound, "N·m",
      fmt::format("half the last digit, and {:g} ms of reading where T moves {:.2g} N·m/s",
                  late_s * 1e3, torque_rate(joint, name)));
}

void add_torques(const PapersJoint& joint, Checks& out) {
  const std::array<double, 6> closed_form = plain_loop_torques_Nm(joint.scenario);
  constexpr double grid_s = 2e-4;  // what the given numbers without inertia were read with
  constexpr double fine_s = 1e-5;
  constexpr double between_samples_s = 5e-6;
  const auto plain_ours = [&](char name) {
    for (const LoopPoint& p : joint.plain_points) {
      if (p.name == name) return p.torque_Nm;
    }
    return std::nan("");
  };
  for (std::size_t i = 0; i < std::size(names); ++i) {
    out.push_back(law_value(
        std::string("T at ") + names[i] + " without inertia and Stribeck effect, in closed form",
        closed_form[i], plain_ours(names[i]),
        half_last_place_Nm + between_samples_s * torque_rate(joint, names[i]), "N·m",
        "0.005 ms of reading between samples 1 ms apart"));
  }
  for (std::size_t i = 0; i < std::size(names); ++i) {
    out.push_back(given_torque(joint, names[i], ", the same as given", plain[i],
                               plain_ours(names[i]), grid_s));
  }
  for (std::size_t i = 0; i < std::size(names); ++i) {
    out.push_back(given_torque(joint, names[i], " with them in, as given", whole[i],
                               joint.point(names[i]).torque_Nm, fine_s));
  }
}

/// Largest deviation [%] of six torques, in the order A to F, from table 2's.
template <class Torques>
double largest_from_table_2(const Torques& torques) {
  double largest = 0;
  for (std::size_t i = 0; i < std::size(names); ++i) {
    largest = std::max(largest, 100 * std::abs(torques[i] / printed::table_2.at(i).torque_Nm - 1));
  }
  return largest;
}

void add_deviations(const PapersJoint& joint, Checks& out) {
  std::array<double, 6> ours{};
  for (std::size_t i = 0; i < std::size(names); ++i) ours[i] = joint.point(names[i]).torque_Nm;
  const char* stated = "as stated, within 0.24 %, rounded";
  constexpr double stated_percent = 0.245;
  out.push_back(
      vanishing("Table 2 against the torques given without inertia and Stribeck effect: "
                "largest deviation",
                largest_from_table_2(plain), 0.20, "%", "as stated, within 0.20 %"));
  out.push_back(vanishing("The same against their closed form",
                          largest_from_table_2(plain_loop_torques_Nm(joint.scenario)),
                          stated_percent, "%",
                          "0.20 % holds for the torques as given, whose E is read late"));
  out.push_back(vanishing("Table 2 against the torques given with them in",
                          largest_from_table_2(whole), stated_percent, "%", stated));
  out.push_back(vanishing("The same against our torques", largest_from_table_2(ours),
                          stated_percent, "%", stated));
}

void add_pairs(const PapersJoint& joint, Checks& out) {
  const double truth = joint.true_mass_kg();
  const auto mass = [&](const std::string& estimator) {
    const SurrogateMass* found = joint.calibration.masses.find(estimator);
    return found != nullptr ? found->mass_kg.value : NAN;
  };
  for (const char* name : {"AB", "CD", "EF"}) {
    out.push_back(law_value(std::string("Pair mean (") + name[0] + " + " + name[1] +
                                ")/2 of the steady loop is free of bias",
                            truth, mass(name), 1e-4 * truth, "kg", "what the program promises"));
  }
  out.push_back(law_value("The mid-line of the whole loop is free of bias", truth, mass("midline"),
                          1e-4 * truth, "kg", "what the program promises"));
  out.push_back(in_words("The paper's rule selects", Origin::printed, "B",
                         joint.calibration.selection.paper_rule));
}

void add_angles(const PapersJoint& joint, Checks& out) {
  out.push_back(printed_value("q_peak", -printed::precise_angle_deg, 5,
                              present(joint.calibration.q_peak_rad).value * degrees_per_rad, 1e-5,
                              "°", "the last printed place"));
  out.push_back(reconstructed_value("q_c = −q_peak", 0.388019, 6,
                                    present(joint.calibration.selection.q_c_rad).value, 1e-6, "rad",
                                    "the last digit"));
}

void add_friction_curve(const PapersJoint& joint, Checks& out) {
  const WaiboerFriction& law = sliding_of(joint.scenario);
  double dip_Nm = INFINITY;
  double dip_rad_s = 0;
  for (double w = 1; w <= 100; w += 0.01) {
    if (law.magnitude_Nm(w) >= dip_Nm) continue;
    dip_Nm = law.magnitude_Nm(w);
    dip_rad_s = w;
  }
  const char* two = "given to two decimals";
  out.push_back(reconstructed_value("Friction curve at rest", 0.88, 2, law.magnitude_Nm(0), 0.005,
                                    "N·m", two));
  out.push_back(reconstructed_value("at its dip", 0.45, 2, dip_Nm, 0.01, "N·m",
                                    "“0.45 near 15 to 25 rad/s”"));
  out.push_back(reconstructed_value("speed of the dip, “near 15 to 25 rad/s”", 20, 0, dip_rad_s, 5,
                                    "rad/s", "the range given"));
  out.push_back(
      reconstructed_value("at 300 rad/s", 1.17, 2, law.magnitude_Nm(300), 0.005, "N·m", two));
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

}  // namespace tribolog::paper
