#pragma once
// A joint's friction in the user's own model of the robot.

#include <string>
#include <vector>

#include "exports/results/archived_joint.h"

namespace tribolog::exports::results {

struct PatchedModel {
  std::string text;
  std::string format;                ///< "URDF", "SDF" or "MJCF"
  std::vector<std::string> changes;  ///< "damping: 0.1 -> 5", one for each number.
  std::vector<std::string> remarks;  ///< Where the numbers are from: dry_and_viscous()'s comments.
};

/// The model with the joint's numbers: `<dynamics damping friction>` of URDF and SDF, attributes
/// damping, frictionloss and, where the options state the arm's inertia, armature of MJCF, which
/// gets mjcf_hard_friction where it says nothing of solimpfriction. Every other byte stays as it
/// is.
/// @param model UTF-8, or another encoding that holds ASCII. @param file its name, for messages.
/// @param name of the joint in the model.
/// @throw InputError at the place: no XML or none of the three formats; a document type; no joint
/// of this name, or two; a joint that is fixed or slides. @throw UsageError as dry_and_viscous().
PatchedModel with_friction(const std::string& model, const std::string& file,
                           const std::string& name, const ArchivedJoint& joint,
                           const SimulatorOptions& options);

}  // namespace tribolog::exports::results
