#include "calibration.h"

namespace tribolog {

std::vector<StageReport> Calibration::stages() const {
  return {rough.stage,   precise.stage, hysteresis.stage, masses.stage,
          viscous.stage, quality.stage, selection.stage,  friction.stage};
}

}  // namespace tribolog
