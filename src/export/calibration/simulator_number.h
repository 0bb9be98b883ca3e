#pragma once
// Which archived numbers may go into a simulator's model.

#include <string>
#include <string_view>

#include "export/calibration/archived_joint.h"

namespace tribolog::archive {

/// A quantity that the format cannot do without.
/// @throw UsageError: it was not identified; or its verdict is not usable and `doubtful_too` was
///        not given; or it is below zero, which no simulator takes.
const Quantity& needed(const ArchivedJoint& joint, std::string_view name, bool doubtful_too);

/// What the format can do without. @param why_not receives why it is left out.
const Quantity* if_usable(const ArchivedJoint& joint, std::string_view name, bool doubtful_too,
                          std::string& why_not);

/// @throw UsageError as needed(), for a quantity that is no number: the viscous curve.
void refuse_doubtful(const ArchivedJoint& joint, std::string_view name, bool doubtful_too);

}  // namespace tribolog::archive
