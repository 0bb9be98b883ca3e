#pragma once
// Internal to the studies of misfit: runs, and what they count.

#include <cstddef>
#include <map>
#include <vector>

#include "calibration/calibration.h"
#include "joint/quantity.h"
#include "simulate/scenario.h"
#include "simulate/simulate_joint.h"
#include "study/misfit.h"

namespace tribolog::study {

struct MisfitRun {
  std::vector<calibration::QuantityVerdict> quantities;
  std::map<joint::Quantity, double> truths;  ///< SI, motor side; NaN: none.
};

/// One run by the whole chain. @param of the case, for `keep`, if there is one.
/// @param unstated the manifest does not say which effects the joint does not have.
calibration::Judgement identified(const MisfitCase& of, const simulate::Scenario& laid,
                                  std::vector<simulate::IdealRecording> ideal,
                                  const simulate::Noise& noise, const KeepLogs& keep,
                                  bool unstated = false);

/// Each quantity that has a truth. @param runs one or more.
std::vector<MisfitQuantity> count_runs(const std::vector<MisfitRun>& runs);

}  // namespace tribolog::study
