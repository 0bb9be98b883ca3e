#include "paper/drawings/joint_diagram.h"

namespace tribolog::paper {

SignalGraph joint_graph(const JointElements& joint) {
  const DriveElements& drive = joint.drive;
  const double n = drive.gear_ratio;
  const auto gravity = [load = joint.load](double q) { return load.torque_Nm(q); };
  const std::size_t choice = joint.friction == FrictionChoice::steady ? 0 : 1;
  SignalGraph graph;
  graph.nodes = {
      {"arm angle", "q", Operation::input},
      {"arm speed", "q\u0307", Operation::input},
      {"arm acceleration", "q\u0308", Operation::input},
      {"speed gear", "n", Operation::gain, n},
      {"acceleration gear", "n", Operation::gain, n},
      {"static friction", "", Operation::function, 0, drive.friction_Nm},
      {"dynamic friction", "", Operation::function, 0, joint.dynamic_friction_Nm},
      {"friction choice", "", Operation::selector, 0, {}, choice},
      {"inertia", "J", Operation::gain, drive.motor_inertia_kgm2},
      {"arm inertia", "I", Operation::gain, joint.arm_inertia_kgm2},
      {"gravity", "", Operation::function, 0, gravity},
      {"arm torque", "", Operation::sum},
      {"gear", "1/n", Operation::gain, 1.0 / n},
      {"torque", "", Operation::sum},
      {"measured speed", "φ\u0307", Operation::output},
      {"measured torque", "T", Operation::output},
      {"measured angle", "q", Operation::output},
  };
  graph.edges = {
      {"arm speed", "speed gear"},
      {"arm acceleration", "acceleration gear"},
      {"speed gear", "static friction"},
      {"speed gear", "dynamic friction"},
      {"static friction", "friction choice"},
      {"dynamic friction", "friction choice"},
      {"acceleration gear", "inertia"},
      {"arm acceleration", "arm inertia"},
      {"arm angle", "gravity"},
      {"arm inertia", "arm torque"},
      {"gravity", "arm torque"},
      {"arm torque", "gear"},
      {"friction choice", "torque"},
      {"inertia", "torque"},
      {"gear", "torque"},
      {"speed gear", "measured speed"},
      {"torque", "measured torque"},
      {"arm angle", "measured angle"},
  };
  return graph;
}

}  // namespace tribolog::paper
