#include "identify/influence_shifts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/requirements.h"

namespace tribolog::identify {
namespace {

using calibration::Influence;
using calibration::InfluenceShift;
using calibration::QuantityVerdict;

/// Half width of what is stated of the masses of the arm's description, as a share; 0: nothing.
double share_of_description(const joint::Manifest& manifest) {
  if (!manifest.arm_gravity || !(manifest.arm_gravity->largest_Nm > 0)) return 0;
  return manifest.uncertainty.description_percent.value_or(0) / 100;
}

/// Half width of what is stated of hoses, as a share of the gravity torque a radian; 0: nothing.
double share_of_hoses(const joint::Manifest& manifest) {
  return manifest.uncertainty.hoses_percent.value_or(0) / 100;
}

/// The dataset with `share` more taken off of the gravity that the other joints' motion changes.
joint::Dataset with_more_taken_off(const joint::Dataset& dataset, double share) {
  joint::Dataset shifted = dataset;
  for (joint::Recording& recording : shifted.recordings) {
    for (std::size_t i = 0; i < recording.others_gravity_Nm.size(); ++i)
      recording.torque_Nm[i] -= share * recording.others_gravity_Nm[i];
  }
  return shifted;
}

/// The dataset with `spring_Nm` a radian more taken off, as hoses may add, from the middle of all
/// motion.
joint::Dataset with_spring_taken_off(const joint::Dataset& dataset, double spring_Nm) {
  joint::Dataset shifted = dataset;
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -lowest;
  for (const joint::Recording& recording : shifted.recordings) {
    for (const double angle : recording.q_rad) {
      lowest = std::min(lowest, angle);
      highest = std::max(highest, angle);
    }
  }
  const double middle = (lowest + highest) / 2;
  for (joint::Recording& recording : shifted.recordings) {
    for (std::size_t i = 0; i < recording.torque_Nm.size(); ++i)
      recording.torque_Nm[i] -= spring_Nm * (recording.q_rad[i] - middle);
  }
  return shifted;
}

/// Of one influence, by the quantities at its limits.
void add_shifts(Influence influence, const std::vector<QuantityVerdict>& stated,
                const std::vector<QuantityVerdict>& less, const std::vector<QuantityVerdict>& more,
                std::vector<InfluenceShift>& shifts) {
  for (std::size_t k = 0; k < stated.size(); ++k) {
    if (!stated[k].estimate) continue;
    InfluenceShift shift{influence, stated[k].quantity, std::nullopt};
    if (less[k].estimate && more[k].estimate) {
      const double value = present(stated[k].estimate).value;
      shift.half_width = std::max(std::abs(present(less[k].estimate).value - value),
                                  std::abs(present(more[k].estimate).value - value));
      if (shift.half_width == 0.0) continue;
    }
    shifts.push_back(shift);
  }
}

}  // namespace

bool has_influence_to_shift(const joint::Manifest& manifest) {
  return share_of_description(manifest) > 0 || share_of_hoses(manifest) > 0;
}

std::vector<InfluenceShift> find_influence_shifts(const joint::Dataset& dataset,
                                                  const calibration::Judgement& stated,
                                                  const QuantitiesOf& quantities_of) {
  std::vector<InfluenceShift> shifts;
  const double of_description = share_of_description(dataset.manifest);
  if (of_description > 0) {
    add_shifts(Influence::description, stated.quantities,
               quantities_of(with_more_taken_off(dataset, -of_description)),
               quantities_of(with_more_taken_off(dataset, of_description)), shifts);
  }
  const QuantityVerdict* gravity = stated.find(joint::Quantity::gravity_torque);
  if (gravity == nullptr || !gravity->estimate) return shifts;
  const double spring_Nm =
      share_of_hoses(dataset.manifest) * std::abs(present(gravity->estimate).value);
  if (spring_Nm > 0) {
    add_shifts(Influence::hoses, stated.quantities,
               quantities_of(with_spring_taken_off(dataset, -spring_Nm)),
               quantities_of(with_spring_taken_off(dataset, spring_Nm)), shifts);
  }
  return shifts;
}

}  // namespace tribolog::identify
