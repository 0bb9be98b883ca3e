#pragma once
// A calibration as JSON: the machine-readable result, archived and embedded in the report.
//
// Schema: calibration_schema() ("tribolog-calibration-1"). Every key is always present
// and in the same order; what a stage could not give is null. Numbers are SI, written with the
// fewest digits that read back as the same double; numbers that are not finite are null. The side
// of a torque or speed is in its key or in the object `units`. Text that is not UTF-8 has U+FFFD in
// place of the offending bytes.

#include <string>

#include "calibration/calibration.h"
#include "calibration/provenance.h"

namespace tribolog::calibration {

/// Indented by two spaces, ends with a line feed. Same calibration and provenance, same bytes.
std::string calibration_json(const Calibration& calibration, const Provenance& provenance);

/// JSON schema of that file (draft 2020-12). It holds of files of earlier versions as well: keys
/// that they lack are not required.
std::string calibration_schema();

}  // namespace tribolog::calibration
