#pragma once
// Internal to calibration.json: the makers of its parts, one source file for each room.

#include <nlohmann/json.hpp>

#include "provenance.h"

#include "calibration.h"
#include "calibration_json/values.h"

namespace tribolog::json {

Json robot(const Manifest& m);
Json drive(const Drive& d);
Json inputs(const std::vector<InputFile>& files);
Json provenance_json(const Provenance& p);
Json cog(const CogSweepResult& r, double gear_ratio);
Json hysteresis(const HysteresisResult& h);
Json surrogate_masses(const SurrogateMassesResult& result);
Json viscous(const ViscousCurvesResult& v);
Json quality(const QualityErrorsResult& q);
Json selection(const SelectionResult& s);
Json friction(const Calibration& c, double gear_ratio);
Json lugre(const LuGreFit& f, double gear_ratio);
Json break_away(const BreakAwayResult& result, double gear_ratio);
Json loop_shapes(const std::vector<LoopShape>& shapes);

}  // namespace tribolog::json
