#include "plan/paper_facts.h"

#include "base/input_file.h"
#include "ingest/manifest/joint_file.h"

namespace tribolog::test {

joint::JointFacts paper_facts() {
  const std::string file = std::string(TRIBOLOG_SOURCE_DIR) + "/examples/plan/joint.toml";
  return ingest::manifest::parse_joint(read_file(file), file);
}

joint::JointFacts bare_facts() {
  const joint::JointFacts all = paper_facts();
  joint::JointFacts f;
  f.robot = all.robot;
  f.joint = all.joint;
  f.gear_ratio = all.gear_ratio;
  f.lowest_rad = all.lowest_rad;
  f.highest_rad = all.highest_rad;
  f.speed_limit_rad_s = all.speed_limit_rad_s;
  f.acceleration_limit_rad_s2 = all.acceleration_limit_rad_s2;
  f.torque_limit_Nm = all.torque_limit_Nm;
  return f;
}

}  // namespace tribolog::test
