#include <algorithm>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "base/shown_text.h"
#include "base/utf8.h"
#include "calibration/archived_calibration.h"
#include "calibration/friction_speeds.h"
#include "calibration/read_calibration.h"
#include "exports/results/archived_joint.h"
#include "exports/results/calibration_exports.h"
#include "exports/results/simulator_numbers.h"
#include "wording/rounding.h"

namespace tribolog::exports::results {

namespace {

constexpr std::string_view formula_starts = "=+-@";

std::string cell(const std::string& text) {
  std::string safe = one_line(text);
  if (!safe.empty() && formula_starts.find(safe.front()) != std::string_view::npos) {
    safe.insert(0, 1, '\'');
  }
  if (safe.find_first_of(",;\"") == std::string::npos) return safe;
  std::string quoted = "\"";
  for (const char c : safe) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

/// A spreadsheet splits a comment at separators like any line: what follows one is no formula.
std::string comment(const std::string& line) {
  std::string text = "# ";
  bool starts_cell = false;
  for (const char c : line) {
    if (starts_cell && formula_starts.find(c) != std::string_view::npos) text += '\'';
    starts_cell = c == ',' || c == ';' || (starts_cell && (c == ' ' || c == '"'));
    text += c;
  }
  return text + "\n";
}

struct SidedFriction {
  calibration::FrictionAtSpeed friction;
  joint::Side side{joint::Side::motor};
};

/// Each speed on both sides. @param count of a few speeds; nothing: of all.
std::vector<SidedFriction> friction_rows(const ArchivedJoint& joint,
                                         std::optional<std::size_t> count) {
  std::vector<calibration::FrictionAtSpeed> speeds =
      calibration::read_curves(joint.calibration).friction_at_speed;
  if (count) speeds = calibration::of_a_table(speeds, *count);
  std::vector<SidedFriction> rows;
  for (const calibration::FrictionAtSpeed& f : speeds) {
    rows.push_back({f, joint::Side::motor});
    rows.push_back({calibration::at_joint(f, joint.entry.facts.gear_ratio), joint::Side::joint});
  }
  return rows;
}

std::string torque_unit(const ArchivedJoint& joint) {
  return unit_of(joint::Quantity::gravity_torque, calibration::torque_unit_of(joint.quantities));
}

}  // namespace

std::string csv_table(const ArchivedJoint& joint) {
  std::string text;
  for (const std::string& line : comment_lines(joint)) text += comment(line);
  text += comment("low and high: 95 % interval; empty: not identified");
  text += comment(
      "friction_at_speed: friction torque at the speed of the last column, on that side; "
      "friction_forward while the angle rises, friction_backward while it falls: with the "
      "torque's offset, which no motion tells from friction that differs");
  text += "quantity,value,low,high,unit,side,verdict,conversion,speed_rad_s\n";
  for (const calibration::SidedQuantity& row :
       calibration::on_both_sides(joint.quantities, joint.entry.facts.gear_ratio)) {
    const calibration::Quantity& q = row.quantity;
    text += cell(q.name) + ",";
    if (q.estimate) append_number(text, q.estimate->value);
    text += ",";
    if (q.estimate) append_number(text, q.estimate->low);
    text += ",";
    if (q.estimate) append_number(text, q.estimate->high);
    text += fmt::format(",{},{},{},{},\n", cell(q.unit), joint::to_string(row.side),
                        calibration::to_string(q.verdict),
                        calibration::conversion_words(row.gear_power));
  }
  for (const SidedFriction& row : friction_rows(joint, std::nullopt)) {
    const auto add = [&](const char* name, const statistics::Estimate& e) {
      text += name;
      for (const double number : {e.value, e.low, e.high}) {
        text += ",";
        append_number(text, number);
      }
      text += fmt::format(",{},{},{},{},", torque_unit(joint), joint::to_string(row.side),
                          calibration::to_string(row.friction.verdict),
                          calibration::conversion_words(row.side == joint::Side::joint ? 1 : 0));
      append_number(text, row.friction.speed_rad_s);
      text += "\n";
    };
    add("friction_at_speed", row.friction.torque_Nm);
    if (row.friction.forward_Nm) add("friction_forward", *row.friction.forward_Nm);
    if (row.friction.backward_Nm) add("friction_backward", *row.friction.backward_Nm);
  }
  return text;
}

std::string feed_forward_table(const ArchivedJoint& joint, const SimulatorOptions& options) {
  const std::vector<SpeedFriction> friction = needed_friction(joint, options);
  std::string text;
  for (const std::string& line : comment_lines(joint)) text += comment(line);
  text += comment(
      "Torque at the joint to apply against friction at a speed of the joint, the mean of both "
      "directions; low and high: 95 % interval");
  text += "speed_rad_s,torque_Nm,low_Nm,high_Nm\n";
  const auto row = [](double sign, double speed, double torque, double low, double high) {
    return fmt::format("{},{},{},{}\n", shortest(sign * speed), shortest(sign * torque),
                       shortest(sign * low), shortest(sign * high));
  };
  for (auto f = friction.rbegin(); f != friction.rend(); ++f) {
    text += row(-1, f->speed_rad_s, f->torque_Nm, f->high_Nm, f->low_Nm);
  }
  for (const SpeedFriction& f : friction) {
    text += row(1, f.speed_rad_s, f.torque_Nm, f.low_Nm, f.high_Nm);
  }
  return text;
}

std::string archive_csv_header() {
  return "id,revision,robot,serial,joint,measured_at,identified_at,temperature_C,payload_kg,"
         "gear_ratio,calibration_verdict,tool_version,quantity,value,low,high,unit,verdict\n";
}

std::string archive_csv_rows(const ArchivedJoint& joint) {
  const calibration::Facts& f = joint.entry.facts;
  const auto number = [](const std::optional<double>& value) {
    std::string text;
    if (value) append_number(text, *value);
    return text;
  };
  std::string of = joint.entry.id;
  for (const std::string& next :
       {std::to_string(joint.entry.revision), cell(f.of.robot), cell(f.of.serial), cell(f.of.joint),
        cell(f.measured_at), cell(f.created_utc), number(f.temperature_C), number(f.payload_kg),
        number(f.gear_ratio), std::string(calibration::to_string(f.verdict)),
        cell(f.tool_version)}) {
    of += "," + next;
  }
  std::string rows;
  for (const calibration::Quantity& q : joint.quantities) {
    const auto& e = q.estimate;
    const auto of_estimate = [&](double statistics::Estimate::* value) {
      return e ? number((*e).*value) : std::string();
    };
    rows += fmt::format(
        "{},{},{},{},{},{},{}\n", of, cell(q.name), of_estimate(&statistics::Estimate::value),
        of_estimate(&statistics::Estimate::low), of_estimate(&statistics::Estimate::high),
        cell(q.unit), calibration::to_string(q.verdict));
  }
  return rows;
}

namespace {

std::string latex_character(char32_t c) {
  switch (c) {
    case U'\\':
      return "\\textbackslash{}";
    case U'^':
      return "\\textasciicircum{}";
    case U'~':
      return "\\textasciitilde{}";
    case U'<':
      return "\\ensuremath{<}";
    case U'>':
      return "\\ensuremath{>}";
    case U'|':
      return "\\ensuremath{|}";
    case U'·':
      return "\\ensuremath{\\cdot}";
    case U'²':
      return "\\ensuremath{^2}";
    case U'°':
      return "\\ensuremath{^\\circ}";
    case U'−':
      return "\\ensuremath{-}";
    case U'×':
      return "\\ensuremath{\\times}";
    case U'⁻':
      return "\\ensuremath{^-}";
    case U'¹':
      return "\\ensuremath{^1}";
    case U'³':
      return "\\ensuremath{^3}";
    default:
      break;
  }
  if (c != U'⁰' && (c < U'⁴' || c > U'⁹')) return "";
  return fmt::format("\\ensuremath{{^{}}}", static_cast<std::uint32_t>(c - U'⁰'));
}

bool is_plain_letter(char32_t c) {
  const bool is_missing_in_plain_fonts = c == U'Ð' || c == U'ð' || c == U'Þ' || c == U'þ';
  return c >= U'À' && c <= U'ÿ' && c != U'÷' && !is_missing_in_plain_fonts;
}

std::string latex_text(const std::string& text) {
  constexpr std::string_view escaped = "#$%&_{}";
  std::string latex;
  const std::string line = one_line(text);
  for (std::size_t i = 0; i < line.size();) {
    const Utf8Character c = first_utf8_character(std::string_view(line).substr(i));
    const std::string bytes = line.substr(i, c.bytes);
    const std::string special = latex_character(c.code_point);
    if (!special.empty()) {
      latex += special;
    } else if (c.code_point < 0x80) {
      if (escaped.find(bytes) != std::string_view::npos) latex += '\\';
      // "--" and "``" would be set as one other character.
      if (latex.ends_with(bytes) && (c.code_point == U'-' || c.code_point == U'`' ||
                                     c.code_point == U'\'' || c.code_point == U',')) {
        latex += "{}";
      }
      latex += bytes;
    } else {
      latex += is_plain_letter(c.code_point)
                   ? bytes
                   : fmt::format("[U+{:04X}]", static_cast<std::uint32_t>(c.code_point));
    }
    i += c.bytes;
  }
  return latex;
}

std::string number_or_dash(const std::string& number) {
  return number.empty() ? "--" : latex_text(number);
}

std::string row_of(const calibration::SidedQuantity& sided) {
  const calibration::Quantity& q = sided.quantity;
  wording::RoundedEstimate shown;
  if (q.estimate) shown = wording::round_by_interval(*q.estimate, {1.0, q.unit});
  std::string verdict = calibration::to_string(q.verdict);
  std::replace(verdict.begin(), verdict.end(), '_', ' ');
  const std::string mark = q.verdict == calibration::Verdict::usable ? "" : "\\textsuperscript{*}";
  return fmt::format("{}{} & {} & {} & {} & {} & {} & {} \\\\\n", latex_text(q.words), mark,
                     number_or_dash(shown.estimate), number_or_dash(shown.low),
                     number_or_dash(shown.high), latex_text(q.unit), joint::to_string(sided.side),
                     verdict);
}

}  // namespace

std::string latex_table(const ArchivedJoint& joint) {
  std::string text;
  for (const std::string& line : comment_lines(joint)) text += "% " + line + "\n";
  text += "% Low and high are the 95 % interval; * marks what is not usable as it is.\n";
  text += "\\begin{tabular}{lrrrlll}\n\\hline\n";
  text += "Quantity & Value & Low & High & Unit & Side & Verdict \\\\\n\\hline\n";
  for (const calibration::SidedQuantity& row :
       calibration::on_both_sides(joint.quantities, joint.entry.facts.gear_ratio)) {
    text += row_of(row);
  }
  for (const SidedFriction& row : friction_rows(joint, calibration::speeds_of_a_table)) {
    const std::string words =
        "Friction at " + wording::significant(row.friction.speed_rad_s, 3) + " rad/s";
    text += row_of({{"friction_at_speed", words, torque_unit(joint), row.friction.verdict,
                     row.friction.torque_Nm},
                    row.side,
                    0});
  }
  return text + "\\hline\n\\end{tabular}\n";
}

}  // namespace tribolog::exports::results
