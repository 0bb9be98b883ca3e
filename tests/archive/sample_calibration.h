#pragma once
// Calibrations to archive, made up.

#include <string>

#include <fmt/format.h>

#include "base/encodings.h"
#include "calibration/archived_calibration.h"

namespace tribolog::test {

/// The joint "J<joint>" of robot "R<robot>", measured on a day of 2026, by number from 0 on, with a
/// Coulomb torque [N·m] and half of its interval.
inline calibration::NewCalibration sample_calibration(int robot, int joint, int day,
                                                      double coulomb_Nm,
                                                      double half_width_Nm = 0.01) {
  calibration::NewCalibration c;
  c.facts.of = {fmt::format("R{}", robot), fmt::format("S{}", robot), fmt::format("J{}", joint)};
  c.facts.measured_at = fmt::format("2026-{:02}-{:02}T10:00:00Z", 1 + day / 28, 1 + day % 28);
  c.facts.measured_on = c.facts.measured_at.substr(0, 10);
  c.facts.time_is_stated = true;
  c.facts.created_utc = "2026-12-01T00:00:00Z";
  c.facts.temperature_C = 25.0;
  c.facts.gear_ratio = 100;
  c.facts.sampling_Hz = 1000.0;
  c.facts.verdict = calibration::Verdict::usable;
  c.facts.sentence = "All stages have their data.";
  c.facts.configuration = "Resamples: 1000\n";
  c.facts.tool_version = "0.1.0";
  c.facts.git_revision = "0123456789ab";
  const statistics::Estimate coulomb{
      coulomb_Nm, coulomb_Nm - half_width_Nm, coulomb_Nm + half_width_Nm, {}};
  c.quantities = {
      {"coulomb_torque", "Coulomb torque", "N·m", calibration::Verdict::usable, coulomb},
      {"viscous_curve", "Viscous curve", "", calibration::Verdict::usable, {}}};
  const std::string log = fmt::format("{} {} {} {}", robot, joint, day, coulomb_Nm);
  c.inputs = {{"dataset.toml", "manifest", 10, sha256_hex("m " + log)},
              {"sweep.csv", "rough_sweep", 20, sha256_hex("s " + log)}};
  c.documents = {{calibration::DocumentKind::calibration, "", "{\"log\": \"" + log + "\"}\n"}};
  return c;
}

}  // namespace tribolog::test
