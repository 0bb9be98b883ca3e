#pragma once
// Recordings that are of another joint, sign or payload than the others of a session.

#include <vector>

#include "method/model/joint_model.h"

namespace tribolog::method::model {

/// Recordings of which a model that suits the others explains next to nothing, as with the torque's
/// sign turned: by least squares, before any fit of the model. Of fewer than six, none.
std::vector<int> foreign_recordings(const Cells& cells);

/// Recordings whose torque lies far from what all others say: misfit, and what is their own. Of
/// fewer than six, none.
std::vector<int> unlike_recordings(const JointModel& model);

}  // namespace tribolog::method::model
