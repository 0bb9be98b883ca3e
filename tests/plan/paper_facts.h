#pragma once
// The paper's joint before it is measured.

#include "joint/joint_facts.h"

namespace tribolog::test {

/// examples/plan/joint.toml
JointFacts paper_facts();

/// The same with what only limits and gear tell.
JointFacts bare_facts();

}  // namespace tribolog::test
