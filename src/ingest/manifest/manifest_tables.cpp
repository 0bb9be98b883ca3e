#include "ingest/manifest/manifest_tables.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>

#include <fmt/format.h>

#include "base/closest_match.h"
#include "ingest/log/units.h"
#include "ingest/manifest/manifest_file.h"
#include "ingest/manifest/toml_table.h"
#include "ingest/manifest/urdf_file.h"
#include "joint/degrees.h"

namespace tribolog::ingest::manifest {

namespace {

constexpr joint::Role all_roles[] = {joint::Role::rough_sweep, joint::Role::precise_sweep,
                                     joint::Role::oscillation, joint::Role::constant_speed,
                                     joint::Role::break_away};

std::vector<joint::Role> read_roles(const TomlTable& table) {
  std::vector<joint::Role> roles;
  if (!table.has("roles")) return roles;
  std::vector<std::string> known;
  for (const joint::Role role : all_roles) known.push_back(joint::to_string(role));
  for (const std::string& name : table.texts("roles")) {
    const auto at = std::find(known.begin(), known.end(), name);
    if (at == known.end()) {
      table.refuse("roles", {"no such role", in_quotes(name), "one of " + list_of_names(known),
                             did_you_mean(name, known)});
    }
    roles.push_back(all_roles[at - known.begin()]);
  }
  if (roles.empty()) {
    table.refuse("roles", {"is empty", "", "one or more roles", "leave it out for all of them"});
  }
  return roles;
}

joint::KnownLoad read_known_load(const TomlTable& table) {
  const std::string hint = "the columns of the log whose sum the load follows";
  joint::KnownLoad load;
  load.amplitude_Nm = table.number("amplitude_Nm");
  if (load.amplitude_Nm == 0) table.refuse("amplitude_Nm", {"not usable", "0", "not 0", ""});
  load.angles = table.texts("angles", hint);
  if (load.angles.empty()) table.refuse("angles", {"is empty", "", "one or more columns", hint});
  for (std::size_t i = 0; i < load.angles.size(); ++i) {
    const auto& name = load.angles[i];
    const auto begin = load.angles.begin();
    const bool is_twice = std::find(begin, begin + static_cast<std::ptrdiff_t>(i), name) !=
                          begin + static_cast<std::ptrdiff_t>(i);
    if (name.empty() || is_twice) {
      table.refuse("angles", {name.empty() ? "holds an empty name" : "names a column twice",
                              in_quotes(name), "columns of the log, each once", ""});
    }
  }
  load.radian_per_unit =
      log::si_factor(log::Quantity::angle, table.text_or("unit", "rad"), table.where("unit"));
  load.phase_rad = table.number_or("phase_deg", 0.0) * joint::rad_per_degree;
  load.roles = read_roles(table);
  load.note = table.text_or("note", "");
  load.stated_at = fmt::format("{}:{}", table.where().file, table.where().line);
  table.refuse_unknown_keys();
  return load;
}

}  // namespace

std::vector<joint::OtherJoint> read_other_joints(const TomlTable& top, const std::string& file) {
  std::vector<joint::OtherJoint> others;
  for (const TomlTable& table : top.one_or_more_tables("other_joint")) {
    joint::OtherJoint other;
    other.name = required_name(table, "");
    const auto is_same = [&](const joint::OtherJoint& one) { return one.name == other.name; };
    if (std::any_of(others.begin(), others.end(), is_same)) {
      table.refuse("name", {"is given twice", in_quotes(other.name), "a name of its own", ""});
    }
    const TomlTable angle = table.table("angle", "angle = { name = ..., unit = ... }");
    other.angle = angle.text("name", "the column's name in the logs");
    if (other.angle.empty()) angle.refuse("name", {"is empty", "", "the column's name", ""});
    const std::string unit = angle.text("unit", "one of " + log::known_units(log::Quantity::angle));
    other.radian_per_unit = log::si_factor(log::Quantity::angle, unit, angle.where("unit"));
    const double sign = angle.number_or("sign", 1);
    if (std::abs(sign) != 1) {
      angle.refuse("sign", {"is neither 1 nor -1", fmt::format("{:g}", sign), "1 or -1",
                            "-1: the column counts the other way round"});
    }
    other.radian_per_unit *= sign;
    if (angle.has("side") && angle.choice("side", {"motor", "joint"}) == 0) {
      other.radian_per_unit /= table.number("gear_ratio", Sign::positive);
    }
    angle.refuse_unknown_keys();
    table.refuse_unknown_keys();
    other.stated_at = fmt::format("{}:{}", file, table.where().line);
    others.push_back(std::move(other));
  }
  return others;
}

std::optional<joint::ArmGravity> read_arm_gravity(const TomlTable& robot,
                                                  const std::string& description) {
  if (!is_urdf(description)) {
    if (robot.has_misplaced("gravity")) {
      robot.refuse("gravity", {"is for a description with masses", "",
                               "description = \"arm.urdf\" beside it", ""});
    }
    return std::nullopt;
  }
  joint::ArmGravity arm;
  arm.description = description;
  if (!robot.has("gravity")) return arm;
  const std::vector<double> stated = robot.numbers("gravity");
  constexpr double weakest_m_s2 = 9.7;  // on Earth, with room
  constexpr double strongest_m_s2 = 9.9;
  double square = 0;
  for (const double one : stated) square += one * one;
  const double size_m_s2 = std::sqrt(square);
  if (stated.size() != arm.gravity_m_s2.size() || size_m_s2 < weakest_m_s2 ||
      size_m_s2 > strongest_m_s2) {
    robot.refuse("gravity", {"is no acceleration of gravity",
                             stated.size() == arm.gravity_m_s2.size()
                                 ? fmt::format("{:.6g} m/s²", size_m_s2)
                                 : fmt::format("{} numbers", stated.size()),
                             "three numbers in the base's frame, as [0, 0, -9.80665]", ""});
  }
  std::copy(stated.begin(), stated.end(), arm.gravity_m_s2.begin());
  return arm;
}

std::vector<joint::KnownLoad> read_known_loads(const TomlTable& top) {
  std::vector<joint::KnownLoad> loads;
  for (const TomlTable& table : top.one_or_more_tables("known_load")) {
    loads.push_back(read_known_load(table));
  }
  return loads;
}

std::optional<joint::StatedGravity> read_known_gravity(const TomlTable& top) {
  const auto table = top.find_table("known_gravity");
  if (!table) return std::nullopt;
  const double amplitude_Nm = table->number("amplitude_Nm", Sign::not_negative);
  const double q_peak_deg =
      amplitude_Nm == 0 ? table->number_or("q_peak_deg", 0.0)
                        : table->number("q_peak_deg", Sign::any,
                                        "the joint angle at which gravity torque is largest");
  const double q_peak_rad = q_peak_deg * joint::rad_per_degree;
  const double percent =
      table->number_or("percent", joint::StatedGravity::usual_percent, Sign::not_negative);
  constexpr double most_percent = 50;  // beyond it nothing is known
  if (percent > most_percent) {
    table->refuse("percent", {"is more than half of the number", fmt::format("{}", percent),
                              fmt::format("from 0 to {}", most_percent),
                              "the half width of the interval that holds it in 95 of 100 cases"});
  }
  table->refuse_unknown_keys();
  return guarded(*table, "amplitude_Nm",
                 [&] { return joint::StatedGravity(amplitude_Nm, q_peak_rad, percent); });
}

std::vector<joint::AcceptanceLimit> read_limits(const TomlTable& manifest) {
  std::vector<std::string> keys;
  for (const joint::LimitedQuantity& quantity : joint::limited_quantities())
    keys.push_back(quantity.key);
  std::vector<joint::AcceptanceLimit> limits;
  for (const TomlTable& table : manifest.tables("limit")) {
    joint::AcceptanceLimit limit;
    limit.quantity = keys[table.choice("quantity", keys)];
    limit.min = table.find_number("min");
    limit.max = table.find_number("max");
    limit.half_width = table.find_number("half_width", Sign::positive);
    limit.half_width_percent = table.find_number("half_width_percent", Sign::positive);
    table.refuse_unknown_keys();
    if (!limit.min && !limit.max && !limit.half_width && !limit.half_width_percent) {
      table.refuse("quantity", {"the limit states no number", "",
                                "one or more of max, min, half_width, half_width_percent", ""});
    }
    if (limit.min && limit.max && *limit.min > *limit.max) {
      table.refuse("min", {"nothing is allowed between min and max",
                           fmt::format("{}..{}", *limit.min, *limit.max), "min <= max", ""});
    }
    limits.push_back(std::move(limit));
  }
  return limits;
}

void refuse_torques_beside_amperes(const TomlTable& effort, const joint::Manifest& manifest) {
  if (!manifest.torque_is_in_amperes) return;
  const bool has_gravity = manifest.known_gravity && manifest.known_gravity->amplitude_Nm() != 0;
  std::string stated = !manifest.known_loads.empty() ? "[[known_load]]"
                       : has_gravity                 ? "[known_gravity]"
                       : manifest.arm_gravity        ? "the masses of robot.description"
                       : manifest.reference          ? "[reference]"
                                                     : "";
  for (const joint::AcceptanceLimit& limit : manifest.limits) {
    const std::string& unit = joint::find_limited_quantity(limit.quantity)->unit;
    const bool is_share_alone = !limit.min && !limit.max && !limit.half_width;
    if (stated.empty() && joint::in_amperes(unit) != unit && !is_share_alone) {
      stated = "[[limit]] " + limit.quantity;
    }
  }
  if (stated.empty()) return;
  effort.refuse("torque_constant_Nm_A",
                {"has to be known beside " + stated, "\"unknown\"",
                 "newton metres per ampere, on the side stated",
                 "without it torques are numbers of amperes, which N·m say nothing about"});
}

std::string required_name(const TomlTable& table, const std::string& hint) {
  std::string name = table.text("name", hint);
  if (std::all_of(name.begin(), name.end(), [](char c) { return c == ' '; })) {
    table.refuse("name", {"is empty", "", "a name", hint});
  }
  return name;
}

std::string read_date(const TomlTable& table, const std::string& key) {
  std::string date = table.text_or_date(key, "");
  if (is_impossible_time(date)) {
    table.refuse(key, {"is no time that there is", in_quotes(date),
                       "2026-01-31, or 2026-01-31T14:05:09+01:00", ""});
  }
  return date;
}

text::TextLogRules read_text_log_rules(const TomlTable& log) {
  constexpr std::array delimiters = {text::Delimiter::comma, text::Delimiter::semicolon,
                                     text::Delimiter::tab, text::Delimiter::spaces};
  text::TextLogRules rules;
  if (log.flag_or("decimal_comma", false)) rules.decimal_mark = text::DecimalMark::comma;
  if (log.has("delimiter")) {
    rules.delimiter =
        delimiters.at(log.choice("delimiter", {"comma", "semicolon", "tab", "spaces"}));
  }
  if (log.has("encoding")) {
    rules.encoding = static_cast<text::TextEncoding>(log.choice("encoding", {"utf8", "latin1"}));
  }
  if (log.has("header_line")) {
    const std::uint64_t line = log.count_or("header_line", 0);
    constexpr std::uint64_t last = 1'000'000'000;
    if (line < 1 || line > last) {
      log.refuse("header_line", {"not usable", std::to_string(line),
                                 "a line's number, from 1 to " + std::to_string(last), ""});
    }
    rules.header_line = static_cast<long>(line);
  }
  rules.skip_bad_rows = log.flag_or("skip_bad_rows", false);
  if (rules.decimal_mark == text::DecimalMark::comma && rules.delimiter == text::Delimiter::comma) {
    log.refuse("delimiter", {"contradicts decimal_comma", "commas for both", "",
                             "commas within numbers and between columns cannot be told apart"});
  }
  log.refuse_unknown_keys();
  return rules;
}

}  // namespace tribolog::ingest::manifest
