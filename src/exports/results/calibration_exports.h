#pragma once
// A calibration in other programs' formats.

#include <string>
#include <vector>

#include "exports/results/archived_joint.h"

namespace tribolog::exports::results {

// The results as JSON for a script.

/// Schema "tribolog-export-1", described by templates/export.schema.json: what the calibration is
/// of, the conversions, each quantity on each side, and the friction curve and the friction at
/// speeds, with intervals and verdicts, on both sides.
/// @param is_on_one_line as in a file of JSON lines.
std::string json_document(const ArchivedJoint& joint, bool is_on_one_line = false);

// The results as variables of MATLAB.

/// A MAT file of level 4, which MATLAB, Octave and SciPy load: each quantity on each side as a row
/// of value, low and high ("coulomb_torque_joint", NaN where it is not known) with "..._unit" and
/// "..._verdict"; "friction_curve_joint" and "..._motor" as rows of speed [rad/s] and torque [N·m],
/// or [A], which "friction_curve_torque_unit" then says;
/// robot, serial, joint, id, gear_ratio and "about". Texts hold the letters of Latin-1.
std::string matlab_file(const ArchivedJoint& joint);

// The results as tables: CSV and LaTeX.

/// Lines behind `#`, then quantity, value, low, high, unit, side, verdict, conversion, speed_rad_s;
/// a row for each quantity and side, and for each speed of the friction and side, which alone has
/// the last. Numbers read back to the same doubles. A text that a spreadsheet would
/// take for a formula (from = + - @) gets an apostrophe in front.
std::string csv_table(const ArchivedJoint& joint);

// A whole archive as one CSV, a row for each quantity of each calibration: SI, motor side.

/// "id,revision,robot,...\n"
std::string archive_csv_header();

/// Numbers read back to the same doubles; texts as in csv_table().
std::string archive_csv_rows(const ArchivedJoint& joint);

// The results as a LaTeX table to \input.

/// Comments, then one `tabular` that needs no package: quantity, value, interval, unit, side and
/// verdict; of friction at speeds a few. Rounded by the intervals. Letters that pdfLaTeX cannot set
/// become [U+XXXX].
std::string latex_table(const ArchivedJoint& joint);

// The results as a calibration certificate for machines.

/// A Digital Calibration Certificate (DCC) of PTB, schema 3.1.2 with D-SI 2.1.0, XML: each quantity
/// on each side with its expanded uncertainty, and what the manifest's [certificate] states. What
/// the schema demands and the manifest does not state is "not stated"; where the schema takes no
/// words, a country is "ZZ", which ISO 3166-1 gives to none, and a day of the measurement is
/// 0001-01-01. A quantity that is not identifiable has no number.
/// @throw UsageError: the calibration's file is not archived, of which the certificate is made.
std::string digital_certificate(const ArchivedJoint& joint);

// The joint's friction for simulators and programs. What is in amperes is in none of them, whatever
// the options. Most take dry friction and a viscous coefficient alone: Coulomb torque and viscous
// coefficient where both are usable, else the line nearest to the friction at the usable speeds,
// which the comments call an approximation and whose largest error they state
// (simulator_numbers.h).

/// A robot of two links with the joint between them, which a parser of URDF loads; its `<dynamics>`
/// is to be copied. Joint side: `damping` is the viscous coefficient [N·m·s/rad], `friction` the
/// dry friction [N·m].
/// @throw UsageError: no friction is usable.
std::string urdf_joint(const ArchivedJoint& joint, const SimulatorOptions& options);

/// The same as SDF, Gazebo's format: a model of two links with the joint between them.
/// @throw as urdf_joint().
std::string sdf_joint(const ArchivedJoint& joint, const SimulatorOptions& options);

/// The usable numbers at the joint as a YAML file of ROS 2 parameters, under `joint_friction`; each
/// with its interval behind it, and what is left out with the reason; friction at speeds as two
/// lists.
/// @throw UsageError: none is usable.
std::string ros2_parameters(const ArchivedJoint& joint, const SimulatorOptions& options);

// The joint's friction as MJCF, MuJoCo's format.

/// A model of one body on one hinge, which MuJoCo loads; its `<joint>` is to be copied. Joint side:
/// `damping` is the viscous coefficient [N·m·s/rad], `frictionloss` the dry friction [N·m].
///
/// `armature` is the rotor's inertia [kg·m²] as the joint feels it. The loop and the sweep show the
/// inertia of rotor, gear and arm together, and a model has the arm's in its bodies: it is the
/// identified one less `arm_inertia_kgm2`, and left out, with a comment, where that is not known or
/// the difference is not above zero.
/// @throw as urdf_joint().
std::string mjcf_joint(const ArchivedJoint& joint, const SimulatorOptions& options);

/// The joint's friction with pre-sliding for MuJoCo 3.12 and newer: a `<dcmotor>` without input
/// that is a passive LuGre friction. Bristle stiffness and damping, and the torque at rest, as
/// identified; Coulomb torque, Stribeck velocity and viscous coefficient of the LuGre curve nearest
/// to the friction at the usable speeds, with its largest error.
/// @throw UsageError: in amperes; no friction at speeds or no bristle stiffness that may be used.
std::string mjcf_lugre(const ArchivedJoint& joint, const SimulatorOptions& options);

// The joint's friction curve for Modelica.

/// A model `JointFriction` that extends Modelica.Mechanics.Rotational.Components.BearingFriction
/// with `tau_pos = [w, tau; ...]`, friction [N·m] against speed [rad/s] from 0 on, and `peak`, the
/// break-away torque by the friction at rest, where that is above 1. On the side that the options
/// say: the bearing stands behind the gear (joint) or before it (motor).
/// @throw UsageError: there is no curve, or it is not usable.
std::string modelica_friction(const ArchivedJoint& joint, const SimulatorOptions& options);

// The same for programs: friction at speeds as a table, and the line beside it. Each throws as
// urdf_joint().

/// A header of C99: numbers as macros, the table, and a function that interpolates it. Floats.
std::string c_header(const ArchivedJoint& joint, const SimulatorOptions& options);

/// A module of Python 3 that needs no other.
std::string python_module(const ArchivedJoint& joint, const SimulatorOptions& options);

/// A script of MATLAB: the parameters of Simscape's Rotational Friction block, with the largest
/// error that its equation leaves, and the table for a lookup block, both directions.
std::string simscape_script(const ArchivedJoint& joint, const SimulatorOptions& options);

/// The arguments of an actuator's configuration in Isaac Lab, Python.
std::string isaac_lab_config(const ArchivedJoint& joint, const SimulatorOptions& options);

/// An `over` of USD with the attributes of PhysxJointAxisAPI. Its viscous coefficient is for
/// degrees, as USD's angles are.
std::string usd_joint(const ArchivedJoint& joint, const SimulatorOptions& options);

/// CSV: a torque with its interval for each usable speed in both directions.
std::string feed_forward_table(const ArchivedJoint& joint, const SimulatorOptions& options);

/// Parameters of Better Actuator Models (bam), its model m1, JSON.
std::string bam_parameters(const ArchivedJoint& joint, const SimulatorOptions& options);

// All formats, by the names of the command line.

struct ExportFormat {
  const char* name;
  const char* content;  ///< For the command's help, a phrase.
  std::string (*text_of)(const ArchivedJoint& joint, const SimulatorOptions& options);
};

const std::vector<ExportFormat>& export_formats();

}  // namespace tribolog::exports::results
