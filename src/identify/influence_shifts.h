#pragma once
// Internal to identify: influences that act on the torque sample by sample, for which no formula
// tells what they do to a quantity. The recordings are identified again with as much more and less
// taken off as the manifest states (type B, JCGM 100, 4.3).

#include <functional>
#include <vector>

#include "calibration/calibration.h"

namespace tribolog::identify {

/// Each quantity as recordings give it, in the verdict's order.
using QuantitiesOf =
    std::function<std::vector<calibration::QuantityVerdict>(const joint::Dataset& dataset)>;

/// Whether the manifest states an influence of this kind that these recordings have.
bool has_influence_to_shift(const joint::Manifest& manifest);

/// The most that each quantity changes from `stated`, to either side: by steps that choose, it need
/// not be the same to both.
std::vector<calibration::InfluenceShift> find_influence_shifts(const joint::Dataset& dataset,
                                                               const calibration::Judgement& stated,
                                                               const QuantitiesOf& quantities_of);

}  // namespace tribolog::identify
