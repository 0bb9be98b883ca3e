#pragma once
// What a model leaves of an oscillation, held against what repeats: lack of fit against pure error,
// harmonic by harmonic.
//
// The residual of each cycle is taken apart into harmonics of the oscillation. What is the same in
// every cycle is the model's error; what differs is noise, of whatever colour. Of P cycles the
// ratio
//
//   F = P |mean coefficient|^2 / (scatter of the coefficients, per component)
//
// follows F(2, 2(P - 1)) where the model is right (a coefficient has two components; R. Pintelon,
// J. Schoukens, System Identification, 2012, ch. 2). What drifts from cycle to cycle along a
// straight line is taken out first: it would count as noise and hide the misfit.
//
// The pattern names the cause: the mean is an offset, even harmonics are a difference between the
// directions, odd ones another law of friction.

#include <cstddef>
#include <vector>

#include "joint/recording.h"

namespace tribolog::method::hysteresis {

struct HarmonicMisfit {
  int harmonic{};         ///< 1: the oscillation's own frequency.
  double amplitude_Nm{};  ///< Of what repeats.
  double phase_rad{};     ///< Of a cosine, from the start of a cycle.
  double noise_Nm{};      ///< Standard error of the amplitude.
  double chance{};        ///< Of an F as large without any misfit.
};

struct CycleMisfit {
  std::size_t cycles{};  ///< That were compared; 0: too few of them, nothing is known.
  std::vector<HarmonicMisfit> harmonics;
  /// Smallest chance of all, times their number (Holm's first step); below a per cent: the model is
  /// wrong.
  double chance{1};
  double systematic_Nm{};  ///< Root mean square of what repeats, less the noise in it.
  double odd_share{};      ///< Of its square: odd harmonics.
  double even_share{};

  [[nodiscard]] bool is_known() const { return cycles > 0; }
  [[nodiscard]] bool is_significant() const;
};

/// @param model_Nm torque of the model at the recording's samples.
/// @param frequency_Hz of the oscillation; the first cycle is left out, it holds the start.
CycleMisfit cycle_misfit(const joint::Recording& recording, const std::vector<double>& model_Nm,
                         double frequency_Hz);

}  // namespace tribolog::method::hysteresis
