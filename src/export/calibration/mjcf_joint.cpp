#include "export/calibration/mjcf_joint.h"

#include <fmt/format.h>

#include "calibration/gear_side.h"
#include "export/calibration/comment_lines.h"
#include "export/calibration/simulator_number.h"
#include "export/calibration/xml_text.h"

namespace tribolog::archive {
namespace {

struct Armature {
  std::optional<double> kgm2;
  std::string words;
};

Armature armature_of(const ArchivedJoint& joint, const SimulatorOptions& options) {
  std::string why_not;
  const Quantity* const inertia = if_usable(joint, "inertia", options.doubtful_too, why_not);
  if (inertia == nullptr) return {{}, "armature is left out: " + why_not};
  const double n = joint.entry.facts.gear_ratio;
  const std::string found = estimate_line(*inertia, n, Side::joint);
  if (!options.arm_inertia_kgm2) {
    return {{},
            "armature is left out: what was identified is of rotor, gear and arm together, and the "
            "arm's inertia is in the bodies of a model; --arm-inertia takes it off. " +
                found};
  }
  const Estimate all = at_joint(*inertia, n);
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
  const Facts& f = joint.entry.facts;
  const Quantity& viscous = needed(joint, "viscous_coefficient", options.doubtful_too);
  const Quantity& coulomb = needed(joint, "coulomb_torque", options.doubtful_too);
  const Armature armature = armature_of(joint, options);
  std::vector<std::string> lines = comment_lines(joint);
  lines.emplace_back(
      "Copy the attributes of <joint> into your joint. The body is there to make this file "
      "complete; its mass and inertia were not identified.");
  const std::vector<std::string> numbers{
      "damping: " + estimate_line(viscous, f.gear_ratio, Side::joint),
      "frictionloss: " + estimate_line(coulomb, f.gear_ratio, Side::joint), armature.words};
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + xml_comment(lines, "") +
         "<mujoco model=\"" + xml_attribute(f.of.robot, "robot") +
         "\">\n"
         "  <compiler angle=\"radian\"/>\n"
         "  <worldbody>\n"
         "    <body>\n"
         "      <inertial pos=\"0 0 0\" mass=\"1\" diaginertia=\"1 1 1\"/>\n" +
         xml_comment(numbers, "      ") + "      <joint name=\"" +
         xml_attribute(f.of.joint, "joint") + "\" type=\"hinge\" damping=\"" +
         shortest(at_joint(viscous, f.gear_ratio).value) + "\" frictionloss=\"" +
         shortest(at_joint(coulomb, f.gear_ratio).value) + "\"" +
         (armature.kgm2 ? " armature=\"" + shortest(*armature.kgm2) + "\"" : "") +
         "/>\n"
         "    </body>\n"
         "  </worldbody>\n"
         "</mujoco>\n";
}

}  // namespace tribolog::archive
