#pragma once
// A small log with verdicts of every kind, and what is found in it.

#include <string>

#include "tribolog/calibration.h"

namespace tribolog::test {

inline const std::string example_manifest = TRIBOLOG_SOURCE_DIR "/examples/ur_like/dataset.toml";

inline Calibration identified_example() { return identify_joint(Dataset::read(example_manifest)); }

}  // namespace tribolog::test
