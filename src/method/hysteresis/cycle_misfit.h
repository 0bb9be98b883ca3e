#pragma once
// Lack of fit of a model to an oscillation, tested against pure error, harmonic by harmonic.
//
// The residual of each cycle is decomposed into harmonics of the oscillation. What is the same in
// every cycle is the model's error; what differs is noise, of whatever colour. For P cycles the
// ratio
//
//   F = P |mean coefficient|^2 / (scatter of the coefficients, per component)
//
// follows F(2, 2(P - 1)) where the model is right (a coefficient has two components; R. Pintelon,
// J. Schoukens, System Identification, 2012, ch. 2). A linear drift from cycle to cycle is removed
// first: it would count as noise and hide the misfit.
//
// The pattern indicates the cause: the mean is an offset, even harmonics are a difference between
// the directions, odd ones another friction law.

#include <cstddef>
#include <vector>

#include "joint/recording.h"

namespace tribolog::method::hysteresis {

struct HarmonicMisfit {
  int harmonic{};         ///< 1: the oscillation's own frequency.
  double amplitude_Nm{};  ///< Of what repeats.
  double phase_rad{};     ///< Of a cosine, relative to the start of a cycle.
  double noise_Nm{};      ///< Standard error of the amplitude.
  double chance{};        ///< Probability of as large an F without any misfit.
};

struct CycleMisfit {
  std::size_t cycles{};  ///< Number of cycles compared; 0: too few, nothing is known.
  std::vector<HarmonicMisfit> harmonics;
  /// Smallest probability of all, times their number (Holm's first step); below 1 %: the model is
  /// wrong.
  double chance{1};
  double systematic_Nm{};  ///< Root mean square of what repeats, less the noise in it.
  double odd_share{};      ///< Share of its square in odd harmonics.
  double even_share{};

  [[nodiscard]] bool is_known() const { return cycles > 0; }
  [[nodiscard]] bool is_significant() const;
};

/// @param model_Nm torque of the model at the recording's samples.
/// @param frequency_Hz of the oscillation; the first cycle is left out, as it contains the start.
CycleMisfit cycle_misfit(const joint::Recording& recording, const std::vector<double>& model_Nm,
                         double frequency_Hz);

}  // namespace tribolog::method::hysteresis
