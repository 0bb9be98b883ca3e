#pragma once
// What the report's loop viewer (templates/viewer/) draws, as compact JSON: the script embedded
// in the report computes no result, it shows what stands here.
//
// "tribolog-loops-1":
//   report       its number; absent of compared calibrations
//   earlier      absent where there is none: words and style; loops, steady, with q and T as above;
//                w and f of the friction curve
//   quantities   of the columns below: words, symbol, unit
//   loops        one per oscillation, columns t, q, T and, where there is one, z, dz and fit
//   (LuGre's
//                torque), sample by sample and thinned out alike; t counts from t0_s, q from
//                centre_deg; midline: q, T of the mid-line; q_peak in q's unit
//   points       "first" (the paper's reading) and "steady": A to F of the first loop, as numbers
//                and as the texts of the report's tables
//   midline      torque at q_peak, as number and text; null if unknown
//   runs         one entry per run of constant speed: w speed, T torque, f reference friction, band
//                half width of the reference in %; null where there is none
//   candidates   one per surrogate mass: f friction and e quality error of each run, T, and texts
//   curves       of compared calibrations alone: label, style and the stretch [from, to) of runs
//                that is its friction curve, by speed; `value` and `half` of runs are the friction
//                and its half width, `value_texts` both as text; no candidates then
//   laws         absent where there is none: w speeds > 0; list: one per law with its friction f at
//                them, mean of the directions, a note as text, and whether it is the likeliest;
//                curve: whose runs they describe
// Numbers are in the unit of their quantity, rounded to six significant digits; what is not finite
// is null.

#include <cstddef>
#include <string>

#include "calibration/calibration.h"
#include "calibration/read_calibration.h"
#include "history/comparison.h"

namespace tribolog::report::viewer {

/// Samples of one loop; many loops share the room of five.
inline constexpr std::size_t most_loop_samples = 2000;

/// What the viewer shows beside the calibration.
struct ReviewContext {
  std::string report{};  ///< Its number, to which remarks belong; empty: none can be made.
  /// Of the joint's calibration before, to be laid over the loops and runs; null: there is none.
  const calibration::RecordedCurves* earlier{};
  std::string earlier_date{};
};

/// Empty if there is neither a loop nor a candidate's curve.
/// Its texts, and what the viewer says itself (`says`), are in the language of the words.
std::string review_json(const calibration::Calibration& calibration,
                        const ReviewContext& context = {});

/// The steady loops and friction curves that the archive keeps of two calibrations, to be laid over
/// each other, in the same form. Time is not kept: t is the phase in degrees from the loop's
/// largest angle. `shown` says which are seen at first, `label` replaces the loop's number and
/// name. Loops, or curves, are there where both have them. Empty: neither are.
std::string compared_curves_json(const history::Comparison& comparison,
                                 const calibration::RecordedCurves& first,
                                 const calibration::RecordedCurves& second);

}  // namespace tribolog::report::viewer
