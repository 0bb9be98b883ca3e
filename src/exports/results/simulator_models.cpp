#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/error.h"
#include "base/requirements.h"
#include "calibration/archived_calibration.h"
#include "exports/results/archived_joint.h"
#include "exports/results/calibration_exports.h"
#include "exports/results/friction_table.h"
#include "exports/results/simulator_numbers.h"
#include "exports/results/xml_text.h"

namespace tribolog::exports::results {

// Text of any origin inside XML.

namespace {

/// For an attribute in double quotes. Never empty: `instead` stands where there is no text.
std::string xml_attribute(const std::string& text, const std::string& instead) {
  return xml_escaped(one_line(text.empty() ? instead : text));
}

/// A comment of several lines. "--", which would end it, becomes "- -".
std::string xml_comment(const std::vector<std::string>& lines, const std::string& indent) {
  std::string text = indent + "<!--\n";
  for (const std::string& line : lines) {
    text += indent + "  ";
    for (const char c : one_line(line)) {
      if (c == '-' && text.back() == '-') text += ' ';
      text += c;
    }
    text += '\n';
  }
  return text + indent + "-->\n";
}

}  // namespace

namespace {

/// A comment with the numbers, and what a format has no place for: the break-away torque.
std::vector<std::string> comments_of(const ArchivedJoint& joint, const DryAndViscous& friction) {
  std::vector<std::string> lines = friction.comments;
  if (const auto* torque = joint.found(joint::Quantity::break_away_torque)) {
    lines.push_back("beside it: " +
                    estimate_line(*torque, joint.entry.facts.gear_ratio, joint::Side::joint));
  }
  return lines;
}

}  // namespace

std::string urdf_joint(const ArchivedJoint& joint, const SimulatorOptions& options) {
  const calibration::Facts& f = joint.entry.facts;
  const DryAndViscous friction = dry_and_viscous(joint, options, "friction", "damping");
  std::vector<std::string> lines = comment_lines(joint);
  lines.emplace_back(
      "Copy <dynamics> into your joint. The links and the type of the joint are there to make "
      "this file complete; they were not identified.");
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + xml_comment(lines, "") +
         "<robot name=\"" + xml_attribute(f.of.robot, "robot") +
         "\">\n"
         "  <link name=\"before_the_joint\"/>\n"
         "  <link name=\"behind_the_joint\"/>\n"
         "  <joint name=\"" +
         xml_attribute(f.of.joint, "joint") +
         "\" type=\"continuous\">\n"
         "    <parent link=\"before_the_joint\"/>\n"
         "    <child link=\"behind_the_joint\"/>\n" +
         xml_comment(comments_of(joint, friction), "    ") + "    <dynamics damping=\"" +
         shortest(friction.viscous_Nms_rad) + "\" friction=\"" + shortest(friction.dry_Nm) +
         "\"/>\n"
         "  </joint>\n"
         "</robot>\n";
}

std::string sdf_joint(const ArchivedJoint& joint, const SimulatorOptions& options) {
  const calibration::Facts& f = joint.entry.facts;
  const DryAndViscous friction = dry_and_viscous(joint, options, "friction", "damping");
  std::vector<std::string> lines = comment_lines(joint);
  lines.emplace_back(
      "Copy <dynamics> into the <axis> of your joint. The links and the axis are there to make "
      "this file complete; they were not identified.");
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + xml_comment(lines, "") +
         "<sdf version=\"1.7\">\n  <model name=\"" + xml_attribute(f.of.robot, "robot") +
         "\">\n"
         "    <link name=\"before_the_joint\"/>\n"
         "    <link name=\"behind_the_joint\"/>\n"
         "    <joint name=\"" +
         xml_attribute(f.of.joint, "joint") +
         "\" type=\"revolute\">\n"
         "      <parent>before_the_joint</parent>\n"
         "      <child>behind_the_joint</child>\n"
         "      <axis>\n"
         "        <xyz>0 0 1</xyz>\n" +
         xml_comment(comments_of(joint, friction), "        ") +
         "        <dynamics>\n"
         "          <damping>" +
         shortest(friction.viscous_Nms_rad) +
         "</damping>\n"
         "          <friction>" +
         shortest(friction.dry_Nm) +
         "</friction>\n"
         "        </dynamics>\n"
         "      </axis>\n"
         "    </joint>\n"
         "  </model>\n"
         "</sdf>\n";
}

namespace {

/// A text as YAML takes it in double quotes.
std::string yaml_text(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : one_line(text)) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + "\"";
}

}  // namespace

std::string ros2_parameters(const ArchivedJoint& joint, const SimulatorOptions& options) {
  refuse_amperes(joint);
  const calibration::Facts& f = joint.entry.facts;
  std::string text;
  for (const std::string& line : comment_lines(joint)) text += "# " + one_line(line) + "\n";
  text += "/**:\n  ros__parameters:\n    joint_friction:\n      joint: " + yaml_text(f.of.joint) +
          "\n      gear_ratio: " + with_point(f.gear_ratio) + "\n";
  struct Parameter {
    const char* key;
    joint::Quantity quantity;
  };
  constexpr std::array parameters{
      Parameter{"coulomb_torque_Nm", joint::Quantity::coulomb_torque},
      Parameter{"viscous_coefficient_Nms_rad", joint::Quantity::viscous_coefficient},
      Parameter{"break_away_torque_Nm", joint::Quantity::break_away_torque},
      Parameter{"stribeck_speed_rad_s", joint::Quantity::stribeck_speed},
      Parameter{"bristle_stiffness_Nm_rad", joint::Quantity::bristle_stiffness},
      Parameter{"inertia_kgm2", joint::Quantity::inertia},
      Parameter{"gravity_torque_Nm", joint::Quantity::gravity_torque}};
  std::size_t count = 0;
  for (const Parameter& one : parameters) {
    std::string why_not;
    const calibration::Quantity* found =
        if_usable(joint, one.quantity, options.doubtful_too, why_not);
    if (found == nullptr) {
      text += fmt::format("      # {}: left out: {}\n", one.key, one_line(why_not));
      continue;
    }
    ++count;
    const std::string value = with_point(calibration::at_joint(*found, f.gear_ratio).value);
    text += fmt::format("      {}: {}  # {}\n", one.key, value,
                        one_line(estimate_line(*found, f.gear_ratio, joint::Side::joint)));
  }
  std::string no_speeds;
  const std::vector<SpeedFriction> friction = a_few(usable_friction(joint, options, no_speeds));
  if (count == 0 && friction.empty()) refuse_export(joint, "no number is usable; " + no_speeds);
  if (friction.empty()) {
    text += fmt::format("      # friction at speeds: left out: {}\n", one_line(no_speeds));
    return text;
  }
  text += "      # Friction at speeds of the joint, the mean of both directions.\n";
  text += "      friction_speeds_rad_s: [" +
          joined(friction, &SpeedFriction::speed_rad_s, with_point) + "]\n";
  text += "      friction_torques_Nm: [" + joined(friction, &SpeedFriction::torque_Nm, with_point) +
          "]\n";
  return text;
}

namespace {

/// A model of one body as far as its joint. @param lines its comment.
std::string mjcf_start(const ArchivedJoint& joint, const std::vector<std::string>& lines) {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + xml_comment(lines, "") +
         "<mujoco model=\"" + xml_attribute(joint.entry.facts.of.robot, "robot") +
         "\">\n"
         "  <compiler angle=\"radian\"/>\n"
         "  <worldbody>\n"
         "    <body>\n"
         "      <inertial pos=\"0 0 0\" mass=\"1\" diaginertia=\"1 1 1\"/>\n";
}

}  // namespace

std::string mjcf_joint(const ArchivedJoint& joint, const SimulatorOptions& options) {
  const calibration::Facts& f = joint.entry.facts;
  const DryAndViscous friction = dry_and_viscous(joint, options, "frictionloss", "damping");
  std::vector<std::string> numbers = comments_of(joint, friction);
  const Armature armature = armature_of(joint, options);
  std::vector<std::string> lines = comment_lines(joint);
  lines.emplace_back(
      "Copy the attributes of <joint> into your joint. The body is there to make this file "
      "complete; its mass and inertia were not identified.");
  numbers.emplace_back(mjcf_hard_friction_words);
  numbers.push_back(armature.words);
  return mjcf_start(joint, lines) + xml_comment(numbers, "      ") + "      <joint name=\"" +
         xml_attribute(f.of.joint, "joint") + "\" type=\"hinge\" damping=\"" +
         shortest(friction.viscous_Nms_rad) + "\" frictionloss=\"" + shortest(friction.dry_Nm) +
         "\" solimpfriction=\"" + mjcf_hard_friction + "\"" +
         (armature.kgm2 ? " armature=\"" + shortest(*armature.kgm2) + "\"" : "") +
         "/>\n"
         "    </body>\n"
         "  </worldbody>\n"
         "</mujoco>\n";
}

std::string mjcf_lugre(const ArchivedJoint& joint, const SimulatorOptions& options) {
  const calibration::Facts& f = joint.entry.facts;
  const std::vector<SpeedFriction> friction = needed_friction(joint, options);
  std::string why_not;
  const auto* const stiffness =
      if_usable(joint, joint::Quantity::bristle_stiffness, options.doubtful_too, why_not);
  if (stiffness == nullptr) {
    refuse_export(joint, why_not + "; mjcf has friction without pre-sliding");
  }
  std::string no_damping;
  const auto* const damping =
      if_usable(joint, joint::Quantity::bristle_damping, options.doubtful_too, no_damping);
  const double stiffness_Nm_rad = calibration::at_joint(*stiffness, f.gear_ratio).value;
  const double damping_Nms_rad =
      damping == nullptr ? 0 : calibration::at_joint(*damping, f.gear_ratio).value;
  const RestTorque rest = rest_torque(joint, options, friction);
  const SteadyLuGre law = nearest_lugre(friction, rest.torque_Nm);
  const Armature armature = armature_of(joint, options);
  std::vector<std::string> lines = comment_lines(joint);
  lines.emplace_back(
      "Copy <dcmotor> into your <actuator>, with your joint's name; it needs MuJoCo 3.12 or newer. "
      "Nothing commands it: input=\"none\" makes it a passive friction torque. The body is there "
      "to "
      "make this file complete; its mass and inertia were not identified.");
  const std::vector<std::string> numbers{
      "lugre: bristle stiffness, bristle damping, Coulomb torque, static torque, Stribeck "
      "velocity, "
      "all at the joint; damping: the viscous coefficient.",
      estimate_line(*stiffness, f.gear_ratio, joint::Side::joint),
      damping == nullptr ? "bristle damping is 0, for it is not usable: " + no_damping
                         : estimate_line(*damping, f.gear_ratio, joint::Side::joint),
      "static torque: " + rest.words + ".",
      fmt::format("Coulomb torque, Stribeck velocity and viscous coefficient are an APPROXIMATION: "
                  "of LuGre's steady curves the one nearest to the friction identified at {} "
                  "speeds, measured at the joint from {}; the largest error there is {}.",
                  friction.size(), speeds_in_words(friction), largest_error_words(law, friction)),
      armature.words};
  std::string attribute;
  for (const double number :
       {stiffness_Nm_rad, damping_Nms_rad, law.coulomb_Nm, law.static_Nm, law.stribeck_rad_s}) {
    attribute += (attribute.empty() ? "" : " ") + shortest(number);
  }
  const std::string name = xml_attribute(f.of.joint, "joint");
  return mjcf_start(joint, lines) + "      <joint name=\"" + name + "\" type=\"hinge\"" +
         (armature.kgm2 ? " armature=\"" + shortest(*armature.kgm2) + "\"" : "") +
         "/>\n"
         "    </body>\n"
         "  </worldbody>\n"
         "  <actuator>\n" +
         xml_comment(numbers, "    ") + "    <dcmotor joint=\"" + name +
         "\" input=\"none\" motorconst=\"0\" resistance=\"1\"\n"
         "             damping=\"" +
         shortest(law.viscous_Nms_rad) + "\" lugre=\"" + attribute +
         "\"/>\n"
         "  </actuator>\n"
         "</mujoco>\n";
}

std::string modelica_friction(const ArchivedJoint& joint, const SimulatorOptions& options) {
  refuse_amperes(joint);
  const calibration::Facts& f = joint.entry.facts;
  const bool at_motor = options.side == joint::Side::motor;
  const std::string why =
      objection(joint, joint::Quantity::viscous_curve, options.doubtful_too, false);
  if (!why.empty()) refuse_export(joint, why);
  FrictionTable table = friction_table(joint);
  if (table.rows.empty()) {
    refuse_export(joint, table.source);
  }
  if (!at_motor) table = at_joint(table, f.gear_ratio);
  const std::string source = table.source;

  std::vector<std::string> lines = comment_lines(joint);
  lines.push_back(fmt::format("tau_pos: friction [N·m] against speed [rad/s] at the {}{}. From {}.",
                              joint::to_string(options.side),
                              at_motor ? ", as archived" : ": archived torques × n, speeds / n",
                              source));
  for (const joint::Quantity one :
       {joint::Quantity::coulomb_torque, joint::Quantity::viscous_coefficient}) {
    const calibration::Quantity* const quantity = joint.found(one);
    if (quantity != nullptr) lines.push_back(estimate_line(*quantity, f.gear_ratio, options.side));
  }
  double peak = 1;
  std::string why_not;
  const calibration::Quantity* const break_away =
      if_usable(joint, joint::Quantity::break_away_torque, options.doubtful_too, why_not);
  if (break_away != nullptr) {
    const double static_Nm = at_motor ? present(break_away->estimate).value
                                      : calibration::at_joint(*break_away, f.gear_ratio).value;
    peak = std::max(peak, static_Nm / table.rows.front().friction_Nm);
    lines.push_back("peak: break-away torque by the torque of the first row, at least 1. " +
                    estimate_line(*break_away, f.gear_ratio, options.side));
  } else {
    lines.push_back("peak is 1: " + why_not);
  }

  std::string text;
  for (const std::string& line : lines) text += "// " + one_line(line) + "\n";
  text += fmt::format(
      "model JointFriction \"Friction of a joint as identified, at the {}\"\n"
      "  extends Modelica.Mechanics.Rotational.Components.BearingFriction(\n"
      "    peak = {},\n"
      "    tau_pos = [\n",
      joint::to_string(options.side), shortest(peak));
  for (std::size_t k = 0; k < table.rows.size(); ++k) {
    text += "      " + shortest(table.rows[k].speed_rad_s) + ", " +
            shortest(table.rows[k].friction_Nm) + (k + 1 < table.rows.size() ? ";\n" : "]);\n");
  }
  return text + "end JointFriction;\n";
}

}  // namespace tribolog::exports::results
