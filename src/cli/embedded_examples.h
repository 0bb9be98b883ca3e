#pragma once
// The files of examples/paper that `tribolog paper` and `tribolog study` are computed from,
// compiled into the program.

#include "base/embedded_file.h"

namespace tribolog::cli {

/// scenario.toml, scenario_noise.toml and am100ib.toml
const std::vector<EmbeddedFile>& embedded_examples();

}  // namespace tribolog::cli
