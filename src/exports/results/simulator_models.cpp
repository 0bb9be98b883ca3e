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
#include "exports/results/xml_text.h"

namespace tribolog::exports::results {

// Which archived numbers may go into a simulator's model.

namespace {

/// Empty: it can be used.
std::string objection(const ArchivedJoint& joint, joint::Quantity quantity, bool doubtful_too,
                      bool is_number) {
  const std::string name = to_string(quantity);
  for (const calibration::Quantity& q : joint.quantities) {
    if (q.name != name) continue;
    const std::string words = printable(q.words);
    if (is_number && !q.estimate) return words + " was not identified";
    const std::string shown =
        is_number ? fmt::format(" of {:.4g} {} (95 %: {:.4g} to {:.4g})", q.estimate->value,
                                printable(q.unit), q.estimate->low, q.estimate->high)
                  : "";
    if (is_number && q.estimate->value < 0) return words + shown + " is below zero";
    if (q.verdict == calibration::Verdict::usable || doubtful_too) return "";
    return fmt::format("{}{} is {}; --doubtful-too exports it all the same", words, shown,
                       calibration::to_string(q.verdict));
  }
  return "the calibration has no " + printable(name);
}

std::string shown_id(const ArchivedJoint& joint) {
  return joint.entry.id.substr(0, calibration::shown_digits);
}

/// @throw UsageError: a simulator would take the numbers of amperes for those of N·m.
void refuse_amperes(const ArchivedJoint& joint) {
  if (!joint.is_in_amperes()) return;
  throw UsageError(shown_id(joint) +
                   ": not exported: the torques are in amperes, since the torque constant was not "
                   "stated; expected N·m; identify the log again with --torque-constant NM_PER_A "
                   "(in a manifest: torque_constant_Nm_A)");
}

/// A quantity that the format cannot do without.
/// @throw UsageError: it was not identified; or its verdict is not usable and `doubtful_too` was
///        not given; or it is below zero, which no simulator takes.
const calibration::Quantity& needed(const ArchivedJoint& joint, joint::Quantity quantity,
                                    bool doubtful_too) {
  const std::string why = objection(joint, quantity, doubtful_too, true);
  if (!why.empty()) throw UsageError(shown_id(joint) + ": not exported: " + why);
  return *joint.found(quantity);
}

/// What the format can do without. @param why_not receives why it is left out.
const calibration::Quantity* if_usable(const ArchivedJoint& joint, joint::Quantity quantity,
                                       bool doubtful_too, std::string& why_not) {
  why_not = objection(joint, quantity, doubtful_too, true);
  return why_not.empty() ? joint.found(quantity) : nullptr;
}

/// @throw UsageError as needed(), for a quantity that is no number: the viscous curve.
void refuse_doubtful(const ArchivedJoint& joint, joint::Quantity quantity, bool doubtful_too) {
  const std::string why = objection(joint, quantity, doubtful_too, false);
  if (!why.empty()) throw UsageError(shown_id(joint) + ": not exported: " + why);
}

}  // namespace

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

/// What a format has no place for, as comments: break-away torque, and the speeds of the curve.
void add_what_has_no_place(const ArchivedJoint& joint, std::vector<std::string>& lines) {
  const double n = joint.entry.facts.gear_ratio;
  if (const auto* torque = joint.found(joint::Quantity::break_away_torque)) {
    lines.push_back("beside it: " + estimate_line(*torque, n, joint::Side::joint));
  }
  const FrictionTable table = friction_table(joint);
  if (table.rows.size() < 2) return;
  const FrictionTable joints = at_joint(table, n);
  const double slowest = joints.rows[1].speed_rad_s;  // behind the row at rest
  const double fastest = joints.rows.back().speed_rad_s;
  lines.push_back(
      slowest < fastest
          ? fmt::format("measured at the joint from {:.4g} to {:.4g} rad/s", slowest, fastest)
          : fmt::format("measured at the joint up to {:.4g} rad/s", fastest));
}

/// What the formats have in common, joint side.
struct JointDynamics {
  std::string damping;   ///< Viscous coefficient [N·m·s/rad].
  std::string friction;  ///< Coulomb torque [N·m].
  std::vector<std::string> comments;
};

/// @param friction as the format calls it.
/// @throw UsageError as needed().
JointDynamics dynamics_of(const ArchivedJoint& joint, const SimulatorOptions& options,
                          const char* friction) {
  refuse_amperes(joint);
  const double n = joint.entry.facts.gear_ratio;
  const calibration::Quantity& viscous =
      needed(joint, joint::Quantity::viscous_coefficient, options.doubtful_too);
  const calibration::Quantity& coulomb =
      needed(joint, joint::Quantity::coulomb_torque, options.doubtful_too);
  JointDynamics out{shortest(calibration::at_joint(viscous, n).value),
                    shortest(calibration::at_joint(coulomb, n).value),
                    {"damping: " + estimate_line(viscous, n, joint::Side::joint),
                     friction + (": " + estimate_line(coulomb, n, joint::Side::joint))}};
  add_what_has_no_place(joint, out.comments);
  return out;
}

}  // namespace

std::string urdf_joint(const ArchivedJoint& joint, const SimulatorOptions& options) {
  const calibration::Facts& f = joint.entry.facts;
  const JointDynamics dynamics = dynamics_of(joint, options, "friction");
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
         xml_comment(dynamics.comments, "    ") + "    <dynamics damping=\"" + dynamics.damping +
         "\" friction=\"" + dynamics.friction +
         "\"/>\n"
         "  </joint>\n"
         "</robot>\n";
}

std::string sdf_joint(const ArchivedJoint& joint, const SimulatorOptions& options) {
  const calibration::Facts& f = joint.entry.facts;
  const JointDynamics dynamics = dynamics_of(joint, options, "friction");
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
         xml_comment(dynamics.comments, "        ") +
         "        <dynamics>\n"
         "          <damping>" +
         dynamics.damping +
         "</damping>\n"
         "          <friction>" +
         dynamics.friction +
         "</friction>\n"
         "        </dynamics>\n"
         "      </axis>\n"
         "    </joint>\n"
         "  </model>\n"
         "</sdf>\n";
}

namespace {

/// ROS takes a number without a point for an integer.
std::string with_point(double number) {
  const std::string text = shortest(number);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

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
  if (count == 0) throw UsageError(shown_id(joint) + ": not exported: no number is usable");
  return text;
}

namespace {

struct Armature {
  std::optional<double> kgm2;
  std::string words;
};

Armature armature_of(const ArchivedJoint& joint, const SimulatorOptions& options) {
  std::string why_not;
  const calibration::Quantity* const inertia =
      if_usable(joint, joint::Quantity::inertia, options.doubtful_too, why_not);
  if (inertia == nullptr) return {{}, "armature is left out: " + why_not};
  const double n = joint.entry.facts.gear_ratio;
  const std::string found = estimate_line(*inertia, n, joint::Side::joint);
  if (!options.arm_inertia_kgm2) {
    return {{},
            "armature is left out: what was identified is of rotor, gear and arm together, and the "
            "arm's inertia is in the bodies of a model; --arm-inertia takes it off. " +
                found};
  }
  const statistics::Estimate all = calibration::at_joint(*inertia, n);
  const double arm_kgm2 = *options.arm_inertia_kgm2;
  if (!(all.low > arm_kgm2)) {
    return {{},
            fmt::format("armature is left out: the data do not show it beside the arm's stated "
                        "{:.6g} kg·m². {}",
                        arm_kgm2, found)};
  }
  return {
      all.value - arm_kgm2,
      fmt::format("armature: {:.6g} kg·m² (95 %: {:.6g} to {:.6g}), less the arm's stated "
                  "{:.6g} kg·m². {}",
                  all.value - arm_kgm2, all.low - arm_kgm2, all.high - arm_kgm2, arm_kgm2, found)};
}

}  // namespace

std::string mjcf_joint(const ArchivedJoint& joint, const SimulatorOptions& options) {
  const calibration::Facts& f = joint.entry.facts;
  JointDynamics dynamics = dynamics_of(joint, options, "frictionloss");
  const Armature armature = armature_of(joint, options);
  std::vector<std::string> lines = comment_lines(joint);
  lines.emplace_back(
      "Copy the attributes of <joint> into your joint. The body is there to make this file "
      "complete; its mass and inertia were not identified.");
  dynamics.comments.push_back(armature.words);
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + xml_comment(lines, "") +
         "<mujoco model=\"" + xml_attribute(f.of.robot, "robot") +
         "\">\n"
         "  <compiler angle=\"radian\"/>\n"
         "  <worldbody>\n"
         "    <body>\n"
         "      <inertial pos=\"0 0 0\" mass=\"1\" diaginertia=\"1 1 1\"/>\n" +
         xml_comment(dynamics.comments, "      ") + "      <joint name=\"" +
         xml_attribute(f.of.joint, "joint") + "\" type=\"hinge\" damping=\"" + dynamics.damping +
         "\" frictionloss=\"" + dynamics.friction + "\"" +
         (armature.kgm2 ? " armature=\"" + shortest(*armature.kgm2) + "\"" : "") +
         "/>\n"
         "    </body>\n"
         "  </worldbody>\n"
         "</mujoco>\n";
}

std::string modelica_friction(const ArchivedJoint& joint, const SimulatorOptions& options) {
  refuse_amperes(joint);
  const calibration::Facts& f = joint.entry.facts;
  const bool at_motor = options.side == joint::Side::motor;
  refuse_doubtful(joint, joint::Quantity::viscous_curve, options.doubtful_too);
  FrictionTable table = friction_table(joint);
  if (table.rows.empty()) {
    throw UsageError(joint.entry.id.substr(0, calibration::shown_digits) +
                     ": not exported: " + table.source);
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
