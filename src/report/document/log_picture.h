#pragma once
// The first picture of a report: the joint's angle through all recordings, with what each part of
// the log was taken for.

#include <optional>

#include "calibration/calibration.h"
#include "report/document/report_view.h"

namespace tribolog::report::document {

/// Nothing for a calibration without its recordings. Recordings stand side by side, as wide as they
/// are long; where one follows another of the same log without a gap, so do their lines.
std::optional<LogPicture> log_picture(const calibration::Calibration& calibration);

}  // namespace tribolog::report::document
