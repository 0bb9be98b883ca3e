#include "export/calibration/urdf_joint.h"

#include "calibration/gear_side.h"
#include "export/calibration/comment_lines.h"
#include "export/calibration/simulator_number.h"
#include "export/calibration/xml_text.h"

namespace tribolog::archive {

std::string urdf_joint(const ArchivedJoint& joint, const SimulatorOptions& options) {
  const Facts& f = joint.entry.facts;
  const Quantity& viscous = needed(joint, "viscous_coefficient", options.doubtful_too);
  const Quantity& coulomb = needed(joint, "coulomb_torque", options.doubtful_too);
  std::vector<std::string> lines = comment_lines(joint);
  lines.emplace_back(
      "Copy <dynamics> into your joint. The links and the type of the joint are there to make "
      "this file complete; they were not identified.");
  const std::vector<std::string> numbers{
      "damping: " + estimate_line(viscous, f.gear_ratio, Side::joint),
      "friction: " + estimate_line(coulomb, f.gear_ratio, Side::joint)};
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
         xml_comment(numbers, "    ") + "    <dynamics damping=\"" +
         shortest(at_joint(viscous, f.gear_ratio).value) + "\" friction=\"" +
         shortest(at_joint(coulomb, f.gear_ratio).value) +
         "\"/>\n"
         "  </joint>\n"
         "</robot>\n";
}

}  // namespace tribolog::archive
