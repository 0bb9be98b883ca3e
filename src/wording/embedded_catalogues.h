#pragma once
// The files of templates/languages/, compiled into the program.

#include "base/embedded_file.h"

namespace tribolog::wording {

/// All of them, sorted by name: "pl_figures.json".
const std::vector<EmbeddedFile>& embedded_catalogues();

}  // namespace tribolog::wording
