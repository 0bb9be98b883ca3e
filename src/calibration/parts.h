#pragma once
// Internal to calibration.json: the functions that state the keys of its parts, one source file per
// component.

#include <optional>
#include <vector>

#include "calibration/calibration.h"
#include "calibration/fields.h"
#include "calibration/provenance.h"

namespace tribolog::calibration {

void state_verdict(Fields& f, const Judgement& judgement);
void state_friction_at_speed(Fields& f, const Judgement& judgement);
void state_model(Fields& f, const method::model::ModelResult& model);
void state_data_checks(Fields& f, const method::checks::DataChecksResult& result);
void state_cog(Fields& f, const method::gravity::CogSweepResult& r, double gear_ratio);
void state_hysteresis(Fields& f, const method::hysteresis::HysteresisResult& h,
                      const Curves& curves);
void state_surrogate_masses(Fields& f, const method::hysteresis::SurrogateMassesResult& result);
void state_viscous(Fields& f, const method::viscous::ViscousCurvesResult& v);
void state_quality(Fields& f, const method::selection::QualityErrorsResult& q);
void state_selection(Fields& f, const method::selection::SelectionResult& s);
void state_cross_checks(Fields& f, const method::selection::CrossChecksResult& result);
void state_ripple(Fields& f, const method::gravity::Ripple& ripple);
void state_position_plan(Fields& f, const std::optional<method::hysteresis::PositionPlan>& plan);
void state_friction(Fields& f, const Calibration& c, double gear_ratio);
void state_known_loads(Fields& f, const std::vector<joint::KnownLoad>& loads);
void state_known_gravity(Fields& f, const std::optional<joint::StatedGravity>& g);
void state_other_joints(Fields& f, const std::vector<joint::OtherJoint>& others);
void state_arm_gravity(Fields& f, const std::optional<joint::ArmGravity>& arm);
void state_break_away(Fields& f, const method::hysteresis::BreakAwayResult& result,
                      double gear_ratio);
void state_loop_shapes(Fields& f, const std::vector<method::hysteresis::LoopShape>& shapes);
void state_lugre(Fields& f, const method::hysteresis::LuGreFit& fit, double gear_ratio);
void state_truth_check(Fields& f, const TruthCheckResult& t);

}  // namespace tribolog::calibration
