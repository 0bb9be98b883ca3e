#pragma once
// Identification of robot joints from their logs, as a library: includes all of its headers.
//
//   const tribolog::Dataset dataset = tribolog::Dataset::read("dataset.toml");
//   const tribolog::Calibration found = tribolog::identify_joint(dataset);
//   for (const tribolog::Quantity& q : found.quantities()) ...
//   found.write("calibration.json");
//
// Units: SI; the side of the gear is in the name or the description of a number (values.h).
// Errors: calls throw only Failure, whose kind says what to do (failure.h); a result that the
//   recordings do not show is not a failure, but a verdict with its reasons.
// Threads: any number at once, on the same Dataset or Calibration too, and in several languages; a
//   Renderer serves one at a time, and is created before other threads are (figures.h).
// The process: nothing is printed, except to a file named "-", which is standard output; no signal
//   handler is set, and neither locale nor umask is changed. If you write to a pipe, ignore
//   SIGPIPE.

#include "tribolog/calibration.h"  // IWYU pragma: export
#include "tribolog/dataset.h"      // IWYU pragma: export
#include "tribolog/failure.h"      // IWYU pragma: export
#include "tribolog/figures.h"      // IWYU pragma: export
#include "tribolog/files.h"        // IWYU pragma: export
#include "tribolog/report.h"       // IWYU pragma: export
#include "tribolog/values.h"       // IWYU pragma: export
