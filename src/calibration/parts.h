#pragma once
// Internal to calibration.json: the functions that write its parts, one source file per component.

#include <optional>

#include <nlohmann/json.hpp>

#include "calibration/calibration.h"
#include "calibration/json_values.h"
#include "calibration/provenance.h"

namespace tribolog::calibration {

Json verdict(const Judgement& judgement);
Json friction_at_speed(const Judgement& judgement);
Json model(const method::model::ModelResult& model);
Json data_checks(const method::checks::DataChecksResult& result);
Json robot(const joint::Manifest& m);
Json certificate(const joint::Certificate& c);
Json drive(const joint::Manifest& m);
Json stated_uncertainty(const joint::StatedUncertainty& u);
Json inputs(const std::vector<joint::InputFile>& files);
Json conversions(const std::vector<joint::InputFile>& inputs);
Json speeds(const std::vector<method::motion::SpeedSource>& sources);
Json provenance_json(const Provenance& p);
Json cog(const method::gravity::CogSweepResult& r, double gear_ratio);
Json hysteresis(const method::hysteresis::HysteresisResult& h, const Curves& curves);
Json surrogate_masses(const method::hysteresis::SurrogateMassesResult& result);
Json viscous(const method::viscous::ViscousCurvesResult& v);
Json quality(const method::selection::QualityErrorsResult& q);
Json selection(const method::selection::SelectionResult& s);
Json cross_checks(const method::selection::CrossChecksResult& result);
Json ripple(const method::gravity::Ripple& ripple);
Json position_plan(const std::optional<method::hysteresis::PositionPlan>& plan);
Json friction(const Calibration& c, double gear_ratio);
Json known_loads(const std::vector<joint::KnownLoad>& loads);
Json other_joints(const std::vector<joint::OtherJoint>& others);
Json arm_gravity(const std::optional<joint::ArmGravity>& arm);
Json known_gravity(const std::optional<joint::StatedGravity>& g);
Json break_away(const method::hysteresis::BreakAwayResult& result, double gear_ratio);
Json loop_shapes(const std::vector<method::hysteresis::LoopShape>& shapes);
Json lugre(const method::hysteresis::LuGreFit& f, double gear_ratio);
Json truth_check(const TruthCheckResult& t);

}  // namespace tribolog::calibration
