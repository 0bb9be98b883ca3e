#pragma once
// From the raw numbers of a TDMS channel to its values: the scales among its properties.

#include <optional>
#include <vector>

#include "ingest/measurement/tdms_metadata.h"

namespace tribolog::ingest::measurement {

/// Polynomials, one after the other; coefficients from that of x^0 on.
using TdmsScaling = std::vector<std::vector<double>>;

/// What an object's properties say of scales: nothing where they say nothing; no polynomial where
/// the values are scaled already.
/// @throw UnreadChannel: a scale that is neither linear nor a polynomial, or one that is damaged.
std::optional<TdmsScaling> read_scaling(const TdmsProperties& properties);

/// @param values raw ones, which become the scaled ones.
void scale(const TdmsScaling& scaling, std::vector<double>& values);

}  // namespace tribolog::ingest::measurement
