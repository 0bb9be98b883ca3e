#include "plan/paper_facts.h"

#include "base/input_file.h"
#include "ingest/manifest/joint_file.h"

namespace tribolog::test {

JointFacts paper_facts() {
  const std::string file = std::string(TRIBOLOG_SOURCE_DIR) + "/examples/plan/joint.toml";
  return parse_joint(read_file(file), file);
}

JointFacts bare_facts() {
  const JointFacts all = paper_facts();
  JointFacts f;
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
