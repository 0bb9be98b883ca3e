#pragma once
// A calibration as JSON: the machine-readable result, archived and embedded in the report.
//
// Schema: templates/calibration.schema.json ("tribolog-calibration-1"). Every key is always present
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

}  // namespace tribolog::calibration
