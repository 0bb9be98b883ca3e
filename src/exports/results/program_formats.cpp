// The joint's friction as programs take it: C, Python, MATLAB, Isaac, a table for feed-forward.

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "exports/results/calibration_exports.h"
#include "exports/results/simulator_numbers.h"
#include "joint/degrees.h"

namespace tribolog::exports::results {
namespace {

/// A name that every language takes: small letters, digits and underscores.
std::string identifier(const std::string& text, const std::string& instead) {
  std::string name;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_letter = byte < 0x80 && std::isalnum(byte) != 0;
    if (is_letter) name += static_cast<char>(std::tolower(byte));
    if (!is_letter && !name.empty() && name.back() != '_') name += '_';
  }
  while (!name.empty() && name.back() == '_') name.pop_back();
  if (name.empty()) return instead;
  return std::isdigit(static_cast<unsigned char>(name.front())) != 0 ? instead + "_" + name : name;
}

std::string name_of(const ArchivedJoint& joint) {
  return identifier(joint.entry.facts.of.joint, "joint");
}

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

/// What stands above the numbers, behind `mark`.
std::string comment(const ArchivedJoint& joint, const std::vector<std::string>& numbers,
                    const std::string& mark) {
  std::string text;
  for (const std::string& line : comment_lines(joint)) text += mark + one_line(line) + "\n";
  for (const std::string& line : numbers) text += mark + one_line(line) + "\n";
  return text;
}

/// Text of a comment of C, which nothing in it ends.
std::string safe(std::string text) {
  for (std::size_t at = text.find("*/"); at != std::string::npos; at = text.find("*/")) {
    text.insert(at + 1, " ");
  }
  return text;
}

/// Between the speeds of the table, of all that are known.
double largest_gap_Nm(const std::vector<SpeedFriction>& all,
                      const std::vector<SpeedFriction>& table) {
  double largest = 0;
  std::size_t k = 1;
  for (const SpeedFriction& f : all) {
    if (table.size() < 2) break;
    while (k + 1 < table.size() && table[k].speed_rad_s < f.speed_rad_s) ++k;
    const SpeedFriction& a = table[k - 1];
    const SpeedFriction& b = table[k];
    const double share = (f.speed_rad_s - a.speed_rad_s) / (b.speed_rad_s - a.speed_rad_s);
    largest = std::max(largest,
                       std::abs(a.torque_Nm + share * (b.torque_Nm - a.torque_Nm) - f.torque_Nm));
  }
  return largest;
}

std::string table_words(const std::vector<SpeedFriction>& all,
                        const std::vector<SpeedFriction>& table) {
  double widest = 0;
  for (const SpeedFriction& f : table) widest = std::max(widest, (f.high_Nm - f.low_Nm) / 2);
  return fmt::format(
      "Friction torque against speed at the joint, the mean of both directions, at {} of {} "
      "speeds; known to ± {:.3g} N·m or better (95 %); interpolation adds {:.2g} N·m at most",
      table.size(), all.size(), widest, largest_gap_Nm(all, table));
}

std::string float_literal(double number) { return with_point(number) + "f"; }

}  // namespace

std::string c_header(const ArchivedJoint& joint, const SimulatorOptions& options) {
  const std::vector<SpeedFriction> all = needed_friction(joint, options);
  const std::vector<SpeedFriction> table = a_few(all);
  const std::string name = name_of(joint) + "_friction";
  const std::string big = upper(name);
  DryAndViscous line =
      dry_and_viscous(joint, options, big + "_COULOMB_NM", big + "_VISCOUS_NMS_RAD");
  line.comments.push_back(big + "_STATIC_NM: " + line.static_words + ".");
  line.comments.push_back(table_words(all, table) + ".");
  std::string text = "/*\n" + safe(comment(joint, line.comments, " * ")) + " */\n";
  text += fmt::format("#ifndef {0}_H\n#define {0}_H\n\n", big);
  text += fmt::format("#define {}_COULOMB_NM {}\n", big, float_literal(line.dry_Nm));
  text += fmt::format("#define {}_VISCOUS_NMS_RAD {}\n", big, float_literal(line.viscous_Nms_rad));
  text += fmt::format("#define {}_STATIC_NM {}\n", big, float_literal(line.static_Nm));
  text += fmt::format("#define {}_POINTS {}\n\n", big, table.size());
  text += fmt::format("static const float {}_speed_rad_s[] = {{{}}};\n", name,
                      joined(table, &SpeedFriction::speed_rad_s, float_literal));
  text += fmt::format("static const float {}_torque_Nm[] = {{{}}};\n\n", name,
                      joined(table, &SpeedFriction::torque_Nm, float_literal));
  text += fmt::format(
      "/* Torque [N·m] to apply in the direction of motion against friction at the joint's speed\n"
      " * [rad/s]. Below the slowest and above the fastest speed the torque there; 0 at rest. */\n"
      "static inline float {0}_Nm(float speed_rad_s) {{\n"
      "  const float speed = speed_rad_s < 0.0f ? -speed_rad_s : speed_rad_s;\n"
      "  float torque = {0}_torque_Nm[0];\n"
      "  int k;\n"
      "  if (speed_rad_s == 0.0f) return 0.0f;\n"
      "  if (speed >= {0}_speed_rad_s[{1}_POINTS - 1]) {{\n"
      "    torque = {0}_torque_Nm[{1}_POINTS - 1];\n"
      "  }} else {{\n"
      "    for (k = 1; k < {1}_POINTS; ++k) {{\n"
      "      const float low = {0}_speed_rad_s[k - 1];\n"
      "      const float high = {0}_speed_rad_s[k];\n"
      "      if (speed < low || speed > high) continue;\n"
      "      torque = {0}_torque_Nm[k - 1] +\n"
      "               (speed - low) / (high - low) * ({0}_torque_Nm[k] - {0}_torque_Nm[k - 1]);\n"
      "      break;\n"
      "    }}\n"
      "  }}\n"
      "  return speed_rad_s < 0.0f ? -torque : torque;\n"
      "}}\n\n#endif\n",
      name, big);
  return text;
}

std::string python_module(const ArchivedJoint& joint, const SimulatorOptions& options) {
  const std::vector<SpeedFriction> all = needed_friction(joint, options);
  const std::vector<SpeedFriction> table = a_few(all);
  DryAndViscous line = dry_and_viscous(joint, options, "COULOMB_Nm", "VISCOUS_Nms_rad");
  line.comments.push_back("STATIC_Nm: " + line.static_words + ".");
  line.comments.push_back(table_words(all, table) + ".");
  return comment(joint, line.comments, "# ") + "from bisect import bisect_right\n\n" +
         fmt::format("COULOMB_Nm = {}\nVISCOUS_Nms_rad = {}\nSTATIC_Nm = {}\n",
                     with_point(line.dry_Nm), with_point(line.viscous_Nms_rad),
                     with_point(line.static_Nm)) +
         fmt::format("SPEEDS_rad_s = [{}]\nTORQUES_Nm = [{}]\nLOW_Nm = [{}]\nHIGH_Nm = [{}]\n",
                     joined(table, &SpeedFriction::speed_rad_s, with_point),
                     joined(table, &SpeedFriction::torque_Nm, with_point),
                     joined(table, &SpeedFriction::low_Nm, with_point),
                     joined(table, &SpeedFriction::high_Nm, with_point)) +
         "\n\n"
         "def friction_Nm(speed_rad_s):\n"
         "    \"\"\"Torque against friction in the direction of motion at the joint's speed.\n\n"
         "    Below the slowest and above the fastest speed the torque there; 0 at rest.\"\"\"\n"
         "    speed = abs(speed_rad_s)\n"
         "    k = bisect_right(SPEEDS_rad_s, speed)\n"
         "    if k == 0 or k == len(SPEEDS_rad_s):\n"
         "        torque = TORQUES_Nm[max(k - 1, 0)]\n"
         "    else:\n"
         "        share = (speed - SPEEDS_rad_s[k - 1]) / (SPEEDS_rad_s[k] - SPEEDS_rad_s[k - 1])\n"
         "        torque = TORQUES_Nm[k - 1] + share * (TORQUES_Nm[k] - TORQUES_Nm[k - 1])\n"
         "    return (speed_rad_s > 0) * torque - (speed_rad_s < 0) * torque\n";
}

namespace {

/// Simscape's Rotational Friction block, from its documentation.
double simscape_torque_Nm(const DryAndViscous& line, double breakaway_rad_s, double speed_rad_s) {
  const double stribeck = speed_rad_s / (breakaway_rad_s * std::sqrt(2.0));
  const double coulomb = speed_rad_s / (breakaway_rad_s / 10);
  return std::sqrt(2 * std::exp(1.0)) * (line.static_Nm - line.dry_Nm) *
             std::exp(-stribeck * stribeck) * stribeck +
         line.dry_Nm * std::tanh(coulomb) + line.viscous_Nms_rad * speed_rad_s;
}

}  // namespace

std::string simscape_script(const ArchivedJoint& joint, const SimulatorOptions& options) {
  const std::vector<SpeedFriction> all = needed_friction(joint, options);
  const std::vector<SpeedFriction> table = a_few(all);
  const std::string name = name_of(joint);
  DryAndViscous line = dry_and_viscous(joint, options, "T_C", "f");
  const double breakaway_rad_s = all.front().speed_rad_s / 2;
  double largest_Nm = 0;
  double at_rad_s = 0;
  for (const SpeedFriction& f : all) {
    const double error_Nm =
        std::abs(simscape_torque_Nm(line, breakaway_rad_s, f.speed_rad_s) - f.torque_Nm);
    if (error_Nm <= largest_Nm) continue;
    largest_Nm = error_Nm;
    at_rad_s = f.speed_rad_s;
  }
  line.comments.push_back(fmt::format(
      "Rotational Friction block: T_brk, w_brk, T_C, f. Its largest error at the measured speeds "
      "is {:.3g} N·m, at {:.4g} rad/s; w_brk is half the slowest measured speed.",
      largest_Nm, at_rad_s));
  line.comments.push_back("T_brk: " + line.static_words + ".");
  line.comments.push_back("1-D Lookup Table block: speed and torque. " + table_words(all, table) +
                          ".");
  std::string speeds;
  std::string torques;
  for (auto f = table.rbegin(); f != table.rend(); ++f) {
    speeds += "-" + shortest(f->speed_rad_s) + " ";
    torques += "-" + shortest(f->torque_Nm) + " ";
  }
  speeds += "0";
  torques += "0";
  for (const SpeedFriction& f : table) {
    speeds += " " + shortest(f.speed_rad_s);
    torques += " " + shortest(f.torque_Nm);
  }
  return comment(joint, line.comments, "% ") +
         fmt::format(
             "{0}.T_brk = {1};  % N*m\n{0}.w_brk = {2};  % rad/s\n{0}.T_C = {3};  % N*m\n"
             "{0}.f = {4};  % N*m/(rad/s)\n{0}.speed = [{5}];  % rad/s\n"
             "{0}.torque = [{6}];  % N*m\n",
             name, shortest(line.static_Nm), shortest(breakaway_rad_s), shortest(line.dry_Nm),
             shortest(line.viscous_Nms_rad), speeds, torques);
}

std::string isaac_lab_config(const ArchivedJoint& joint, const SimulatorOptions& options) {
  DryAndViscous line = dry_and_viscous(joint, options, "dynamic_friction", "viscous_friction");
  const Armature armature = armature_of(joint, options);
  line.comments.push_back(
      "friction: " + line.static_words +
      ". All are efforts at the joint (N·m), "
      "as Isaac Lab 2.2 and newer take them with Isaac Sim 5.0 and newer; before, friction was a "
      "coefficient without a unit.");
  line.comments.push_back(armature.words);
  line.comments.push_back(fmt::format(
      "Use: ImplicitActuatorCfg(joint_names_expr=[\"...\"], stiffness=..., damping=..., **{})",
      name_of(joint)));
  return comment(joint, line.comments, "# ") +
         fmt::format(
             "{} = dict(\n    friction={},\n    dynamic_friction={},\n"
             "    viscous_friction={},\n{})\n",
             name_of(joint), with_point(line.static_Nm), with_point(line.dry_Nm),
             with_point(line.viscous_Nms_rad),
             armature.kgm2 ? "    armature=" + with_point(*armature.kgm2) + ",\n" : "");
}

std::string usd_joint(const ArchivedJoint& joint, const SimulatorOptions& options) {
  DryAndViscous line =
      dry_and_viscous(joint, options, "dynamicFrictionEffort", "viscousFrictionCoefficient");
  const Armature armature = armature_of(joint, options);
  line.comments.push_back("staticFrictionEffort: " + line.static_words + ".");
  line.comments.push_back(
      "viscousFrictionCoefficient stands here for degrees, as USD has angles: N·m·s/°.");
  line.comments.push_back(armature.words);
  const auto attribute = [](const char* name, double value) {
    return fmt::format("    float physxJointAxis:angular:{} = {}\n", name, shortest(value));
  };
  return "#usda 1.0\n" + comment(joint, line.comments, "# ") +
         fmt::format(
             "over \"{}\" (\n    prepend apiSchemas = [\"PhysxJointAxisAPI:angular\"]\n)\n{{\n",
             name_of(joint)) +
         attribute("staticFrictionEffort", line.static_Nm) +
         attribute("dynamicFrictionEffort", line.dry_Nm) +
         attribute("viscousFrictionCoefficient", line.viscous_Nms_rad / joint::degrees_per_rad) +
         (armature.kgm2 ? attribute("armature", *armature.kgm2) : "") + "}\n";
}

std::string bam_parameters(const ArchivedJoint& joint, const SimulatorOptions& options) {
  const DryAndViscous line = dry_and_viscous(joint, options, "friction_base", "friction_viscous");
  const Armature armature = armature_of(joint, options);
  nlohmann::ordered_json json{{"model", "m1"}, {"actuator", one_line(joint.entry.facts.of.joint)}};
  json["friction_base"] = line.dry_Nm;
  json["friction_viscous"] = line.viscous_Nms_rad;
  if (armature.kgm2) json["armature"] = *armature.kgm2;
  std::vector<std::string> about;
  for (const std::string& text : comment_lines(joint)) about.push_back(one_line(text));
  for (const std::string& text : line.comments) about.push_back(one_line(text));
  json["about"] = about;
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace tribolog::exports::results
