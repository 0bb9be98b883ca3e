#pragma once
// The paper's joint before it is measured.

#include "joint/joint_facts.h"

namespace tribolog::test {

/// examples/plan/joint.toml
joint::JointFacts paper_facts();

/// The same with what only limits and gear tell.
joint::JointFacts bare_facts();

}  // namespace tribolog::test
