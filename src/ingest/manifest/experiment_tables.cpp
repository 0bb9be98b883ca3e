#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "ingest/manifest/scenario_tables.h"
#include "ingest/manifest/toml_table.h"
#include "joint/degrees.h"
#include "simulate/motion.h"

namespace tribolog::ingest::manifest {
namespace {

constexpr double shortest_sweep_rad = 1e-6;
constexpr std::uint64_t most_positions = 99;  // file names have two digits
constexpr std::uint64_t most_repeats = 49;    // in each of two directions

/// The key in use and its factor to radians. `after` is what follows the unit: "", "_s", "_s2".
std::pair<std::string, double> angle_key(const TomlTable& table, const std::string& name,
                                         const std::string& after) {
  std::string in_rad = name + "_rad" + after;
  std::string in_deg = name + "_deg" + after;
  const bool has_rad = table.has(in_rad);
  const bool has_deg = table.has(in_deg);
  if (has_rad && has_deg) table.refuse(in_deg, {"is given as " + in_rad + " too", "", "one", ""});
  return has_deg ? std::pair(in_deg, joint::rad_per_degree) : std::pair(in_rad, 1.0);
}

double read_in_rad(const TomlTable& table, const std::string& name, const std::string& after,
                   Sign sign) {
  const auto [key, factor] = angle_key(table, name, after);
  return factor * table.number(key, sign, "or " + name + "_deg" + after);
}

double read_cycles(const TomlTable& table) {
  const double cycles = table.number("cycles", Sign::positive);
  if (cycles < 1) table.refuse("cycles", {"not usable", fmt::format("{}", cycles), ">= 1", ""});
  return cycles;
}

}  // namespace

double read_angle(const TomlTable& table, const std::string& name, Sign sign) {
  return read_in_rad(table, name, "", sign);
}

double read_angular_rate(const TomlTable& table, const std::string& name,
                         const std::string& after) {
  return read_in_rad(table, name, after, Sign::positive);
}

double read_angle_or(const TomlTable& table, const std::string& name, double otherwise_rad) {
  const auto [key, factor] = angle_key(table, name, "");
  return table.has(key) ? factor * table.number(key) : otherwise_rad;
}

simulate::SweepExperiment read_sweep(const TomlTable& table) {
  simulate::SweepExperiment e;
  e.from_rad = read_angle(table, "from");
  e.to_rad = read_angle(table, "to");
  e.speed_rad_s = read_angular_rate(table, "speed", "_s");
  e.both_directions = table.flag_or("both_directions", e.both_directions);
  const auto [key, factor] = angle_key(table, "acceleration", "_s2");
  if (table.has(key)) e.acceleration_rad_s2 = factor * table.number(key, Sign::positive);
  e.sample_rate_Hz = table.number_or("sample_rate_Hz", e.sample_rate_Hz, Sign::positive);
  table.refuse_unknown_keys();
  const std::string to_key = angle_key(table, "to", "").first;
  if (std::abs(e.to_rad - e.from_rad) < shortest_sweep_rad) {
    table.refuse(to_key, {"the sweep ends where it starts", fmt::format("{} rad", e.to_rad),
                          "another angle than from", ""});
  }
  guarded(table, to_key, [&] {
    return simulate::TravelMotion(
        {e.from_rad, e.to_rad, e.speed_rad_s, e.acceleration_rad_s2, e.both_directions});
  });
  return e;
}

simulate::SineSweepExperiment read_sine_sweep(const TomlTable& table) {
  simulate::SineSweepExperiment e;
  e.centre_rad = read_angle(table, "centre");
  e.amplitude_rad = read_angle(table, "amplitude", Sign::positive);
  e.frequency_Hz = table.number("frequency_Hz", Sign::positive);
  e.cycles = read_cycles(table);
  e.sample_rate_Hz = table.number_or("sample_rate_Hz", e.sample_rate_Hz, Sign::positive);
  table.refuse_unknown_keys();
  return e;
}

std::vector<simulate::OscillationExperiment> read_oscillation(const TomlTable& table,
                                                              double gear_ratio) {
  simulate::OscillationExperiment e;
  e.centre_rad = read_angle(table, "centre");
  e.amplitude_rad = read_angle(table, "amplitude", Sign::positive);
  e.frequency_Hz = table.number("frequency_Hz", Sign::positive);
  e.cycles = read_cycles(table);
  e.sample_rate_Hz = table.number_or("sample_rate_Hz", e.sample_rate_Hz, Sign::positive);
  e.record_bristle = table.flag_or("record_bristle", e.record_bristle);
  const std::uint64_t positions = table.count_or("positions", 1);
  if (positions < 1 || positions > most_positions) {
    table.refuse("positions", {"not usable", fmt::format("{}", positions),
                               fmt::format("a whole number from 1 to {}", most_positions), ""});
  }
  table.refuse_unknown_keys();
  return simulate::spread_over_motor_turn(e, positions, gear_ratio);
}

simulate::ConstantSpeedExperiment read_constant_speed(const TomlTable& table) {
  simulate::ConstantSpeedExperiment e;
  e.motor_speeds_rad_s = table.numbers("motor_speeds_rad_s", Sign::positive);
  if (e.motor_speeds_rad_s.empty()) {
    table.refuse("motor_speeds_rad_s", {"is empty", "", "one speed or more", ""});
  }
  e.both_directions = table.flag_or("both_directions", e.both_directions);
  e.centre_rad = read_angle(table, "centre");
  e.largest_travel_rad = read_angle(table, "largest_travel", Sign::positive);
  e.longest_plateau_s = table.number("longest_plateau_s", Sign::positive);
  e.acceleration_rad_s2 = read_angular_rate(table, "acceleration", "_s2");
  e.sample_rate_Hz = table.number_or("sample_rate_Hz", e.sample_rate_Hz, Sign::positive);
  table.refuse_unknown_keys();
  return e;
}

simulate::BreakAwayExperiment read_break_away(const TomlTable& table) {
  simulate::BreakAwayExperiment e;
  e.centre_rad = read_angle(table, "centre");
  e.rate_Nm_s = table.number("rate_Nm_s", Sign::positive);
  e.largest_torque_Nm = table.number("largest_torque_Nm", Sign::positive);
  const auto [key, factor] = angle_key(table, "largest_travel", "");
  if (table.has(key)) e.largest_travel_rad = factor * table.number(key, Sign::positive);
  e.repeats = table.count_or("repeats", e.repeats);
  if (e.repeats < 1 || e.repeats > most_repeats) {
    table.refuse("repeats", {"not usable", fmt::format("{}", e.repeats),
                             fmt::format("a whole number from 1 to {}", most_repeats), ""});
  }
  e.both_directions = table.flag_or("both_directions", e.both_directions);
  e.sample_rate_Hz = table.number_or("sample_rate_Hz", e.sample_rate_Hz, Sign::positive);
  table.refuse_unknown_keys();
  return e;
}

simulate::Noise read_noise(const TomlTable& table) {
  simulate::Noise noise;
  const auto amount = [&](const char* key) { return table.number_or(key, 0, Sign::not_negative); };
  noise.torque_white_Nm = amount("torque_white_Nm");
  noise.torque_step_Nm = amount("torque_step_Nm");
  noise.encoder_counts_per_turn = amount("encoder_counts_per_turn");
  noise.speed_filter_Hz = amount("speed_filter_Hz");
  noise.clock_jitter_s = amount("clock_jitter_s");
  noise.lost_percent = amount("lost_percent");
  if (noise.lost_percent >= 100) {
    table.refuse("lost_percent",
                 {"leaves no sample", fmt::format("{}", noise.lost_percent), "< 100", ""});
  }
  noise.seed = table.count_or("seed", noise.seed);
  for (const TomlTable& entry : table.tables("ripple")) {
    simulate::Noise::Ripple ripple;
    ripple.amplitude_Nm = entry.number("amplitude_Nm", Sign::not_negative);
    ripple.periods_per_turn = entry.number("periods_per_turn", Sign::positive);
    ripple.phase_rad = read_angle_or(entry, "phase", 0.0);
    entry.refuse_unknown_keys();
    noise.ripple.push_back(ripple);
  }
  table.refuse_unknown_keys();
  return noise;
}

simulate::LogForm read_log_form(const TomlTable& table) {
  constexpr std::uint64_t most_decimals = 17;
  simulate::LogForm form;
  form.torque_constant_Nm_A = table.number_or("torque_constant_Nm_A", 0, Sign::positive);
  if (table.has("decimals")) {
    form.decimals = table.count_or("decimals", 0);
    if (*form.decimals > most_decimals) {
      table.refuse("decimals", {"not usable", fmt::format("{}", *form.decimals),
                                fmt::format("a whole number up to {}", most_decimals), ""});
    }
  }
  table.refuse_unknown_keys();
  return form;
}

joint::GravityLoad read_load(const TomlTable& load) {
  const double mass_kg = load.number("mass_kg", Sign::positive);
  const double distance_m = load.number("distance_m", Sign::positive);
  const double q_peak_rad = read_angle(load, "q_peak");
  const double gravity_m_s2 = load.number_or("gravity_m_s2", 9.81, Sign::positive);
  load.refuse_unknown_keys();
  return guarded(load, "mass_kg",
                 [&] { return joint::GravityLoad(mass_kg, distance_m, q_peak_rad, gravity_m_s2); });
}

}  // namespace tribolog::ingest::manifest
