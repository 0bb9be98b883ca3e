#pragma once
// Internal to calibration.json: the makers of its parts, one source file for each room.

#include <optional>

#include <nlohmann/json.hpp>

#include "calibration/calibration.h"
#include "calibration/json_values.h"
#include "calibration/provenance.h"

namespace tribolog::json {

Json verdict(const Judgement& judgement);
Json data_checks(const DataChecksResult& result);
Json robot(const Manifest& m);
Json drive(const Manifest& m);
Json inputs(const std::vector<InputFile>& files);
Json conversions(const std::vector<InputFile>& inputs);
Json speeds(const std::vector<SpeedSource>& sources);
Json provenance_json(const Provenance& p);
Json cog(const CogSweepResult& r, double gear_ratio);
Json hysteresis(const HysteresisResult& h);
Json surrogate_masses(const SurrogateMassesResult& result);
Json viscous(const ViscousCurvesResult& v);
Json quality(const QualityErrorsResult& q);
Json selection(const SelectionResult& s);
Json intervals(const IntervalsResult& result);
Json cross_checks(const CrossChecksResult& result);
Json ripple(const Ripple& ripple);
Json position_plan(const std::optional<PositionPlan>& plan);
Json friction(const Calibration& c, double gear_ratio);
Json curve_model(const CurveModelChoice& c);
Json direction_lines(const DirectionLinesResult& r, double gear_ratio);
Json direction_asymmetry(const DirectionAsymmetryResult& a);
Json load_dependence(const LoadDependenceResult& l);
Json run_gravity(const RunGravityResult& r, double gear_ratio);
Json known_loads(const std::vector<KnownLoad>& loads);
Json known_gravity(const std::optional<StatedGravity>& g);
Json break_away(const BreakAwayResult& result, double gear_ratio);
Json loop_shapes(const std::vector<LoopShape>& shapes);
Json lugre(const LuGreFit& f, double gear_ratio);
Json truth_check(const TruthCheckResult& t);

}  // namespace tribolog::json
