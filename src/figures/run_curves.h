#pragma once
// Curves over the constant-speed runs, as recorded or folded.

#include <optional>
#include <string>
#include <vector>

#include "calibration/calibration.h"
#include "figures/estimator_style.h"
#include "render/figure/figure.h"
#include "wording/axis_scale.h"

namespace tribolog::figures {

/// Adds one value per run over signed motor speed in this style. Runs of constant speed
/// are joined by a line that breaks at zero speed; angle bins of a sweep stay single markers.
/// @param values one per run, SI.
void add_run_curve(render::figure::Panel& panel,
                   const method::viscous::ViscousCurvesResult& viscous, const SeriesStyle& style,
                   const std::string& label, const std::vector<double>& values,
                   const wording::AxisScale& scale);

/// Adds the reference: the analytic curve at many speeds where it is known, else its value per run.
void add_reference(render::figure::Panel& panel, const calibration::Calibration& calibration,
                   const wording::AxisScale& scale);

/// "analytic curve" or "half the difference of the directions"
std::string reference_words(method::selection::CurveReference reference);

/// The legend's text for the reference.
std::string reference_label(const calibration::Calibration& calibration);

/// "A (80.00 kg)"; "no gravity" where that is stated.
std::string candidate_words(const calibration::Calibration& calibration,
                            method::hysteresis::Estimator estimator);

// Friction folded: size over size of motor speed, so that the two directions lie on each other.
// Signed along the motion: friction that would drive the joint shows as negative.

/// Both directions of an estimator's curve as markers; the recommended one with the 95 % bars of
/// its runs that are longer than a marker. Nothing if there is no such curve, or no estimator.
void add_folded_curve(render::figure::Panel& panel, const calibration::Calibration& calibration,
                      std::optional<method::hysteresis::Estimator> estimator,
                      const wording::AxisScale& scale, bool recommended);

/// The reference over these speeds (sizes).
void add_folded_reference(render::figure::Panel& panel, const calibration::Calibration& calibration,
                          const wording::Extent& speeds, const wording::AxisScale& scale);

/// The likeliest law of the model over the speeds measured, and eq. (6) where it was fitted.
void add_fitted_laws(render::figure::Panel& panel, const calibration::Calibration& calibration,
                     const wording::AxisScale& scale);

/// What the likeliest law leaves of a curve, run by run. @param calibration with a law.
std::vector<double> left_by_law(const calibration::Calibration& calibration,
                                const method::viscous::ViscousCurve& curve);
/// The same drawn along the motion. @param left_Nm of left_by_law().
void add_residuals(render::figure::Panel& panel, const calibration::Calibration& calibration,
                   const std::vector<double>& left_Nm, const wording::AxisScale& scale);

}  // namespace tribolog::figures
