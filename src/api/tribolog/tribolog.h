#pragma once
// Identification of robot joints from their logs, as a library: all of it.
//
//   const tribolog::Dataset dataset = tribolog::Dataset::read("dataset.toml");
//   const tribolog::Calibration found = tribolog::identify_joint(dataset);
//   for (const tribolog::Quantity& q : found.quantities()) ...
//   found.write("calibration.json");
//
// Units: SI; a number's side of the gear is in its name or its description (values.h).
// Errors: every call throws Failure alone, of the kind that says what to do (failure.h); results
//   that the recordings do not show are no failure, but a verdict with its reasons.
// Threads: any number at once, on the same Dataset or Calibration too, and in several languages; a
//   Renderer is for one at a time, and is made before other threads are (figures.h).
// The process: nothing is printed, but for a file named "-", which is standard output; no signal
//   handler is set, and neither locale nor umask is changed. Who writes to a pipe ignores SIGPIPE.

#include "tribolog/calibration.h"  // IWYU pragma: export
#include "tribolog/dataset.h"      // IWYU pragma: export
#include "tribolog/failure.h"      // IWYU pragma: export
#include "tribolog/figures.h"      // IWYU pragma: export
#include "tribolog/files.h"        // IWYU pragma: export
#include "tribolog/report.h"       // IWYU pragma: export
#include "tribolog/values.h"       // IWYU pragma: export
