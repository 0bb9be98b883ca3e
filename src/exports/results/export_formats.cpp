#include "exports/results/calibration_exports.h"

namespace tribolog::exports::results {
namespace {

/// Of a format that has all numbers, marked with their verdicts, whatever the options.
template <auto text_of>
std::string without_options(const ArchivedJoint& joint, const SimulatorOptions&) {
  return text_of(joint);
}

std::string indented_json(const ArchivedJoint& joint, const SimulatorOptions&) {
  return json_document(joint);
}

}  // namespace

const std::vector<ExportFormat>& export_formats() {
  static const std::vector<ExportFormat> formats{
      {"csv", "every quantity and friction at every speed, on both sides of the gear",
       without_options<csv_table>},
      {"json", "the same for a script", indented_json},
      {"mat", "the same for MATLAB, Octave and SciPy", without_options<matlab_file>},
      {"latex", "the same as a table to \\input", without_options<latex_table>},
      {"dcc",
       "Digital Calibration Certificate 3.1.2 (XML), with what [certificate] of the manifest "
       "states",
       without_options<digital_certificate>},
      {"urdf", "<dynamics damping friction>", urdf_joint},
      {"sdf", "the same for Gazebo", sdf_joint},
      {"mjcf", "MuJoCo's <joint damping frictionloss armature>", mjcf_joint},
      {"mjcf-lugre", "MuJoCo's <dcmotor> as passive LuGre friction (3.12 and newer)", mjcf_lugre},
      {"isaaclab", "arguments of an actuator's configuration in Isaac Lab (Python)",
       isaac_lab_config},
      {"usd", "attributes of PhysxJointAxisAPI, for Isaac Sim", usd_joint},
      {"modelica", "tau_pos and peak of Modelica.Mechanics.Rotational.Components.BearingFriction",
       modelica_friction},
      {"simscape", "a MATLAB script: the Rotational Friction block, and a lookup table",
       simscape_script},
      {"ros2", "parameters of a node (YAML)", ros2_parameters},
      {"c", "a C header: macros, friction over speed, a function", c_header},
      {"python", "a Python module with the same", python_module},
      {"feedforward", "CSV: torque with its interval against speed, both directions",
       feed_forward_table},
      {"bam", "parameters of Better Actuator Models, model m1 (JSON)", bam_parameters},
  };
  return formats;
}

}  // namespace tribolog::exports::results
