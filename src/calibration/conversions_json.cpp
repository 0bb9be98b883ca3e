// From the columns of the logs to signals, and where speeds come from.

#include <utility>

#include "calibration/parts.h"
#include "joint/shared_conversions.h"

namespace tribolog::json {

Json conversions(const std::vector<InputFile>& inputs) {
  Json list = Json::array();
  for (const SharedConversion& shared : shared_conversions(inputs)) {
    const ColumnConversion& c = shared.conversion;
    Json steps = Json::array();
    for (const ConversionStep& step : c.steps) {
      steps.push_back({{"reason", to_string(step.reason)},
                       {"number", number(step.number)},
                       {"divides", step.divides}});
    }
    list.push_back({{"signal", to_string(c.signal)},
                    {"column", c.column},
                    {"unit", c.unit},
                    {"steps", std::move(steps)},
                    {"factor", number(c.factor())},
                    {"si_unit", c.si_unit},
                    {"side", c.side ? Json(to_string(*c.side)) : Json(nullptr)},
                    {"files", shared.files}});
  }
  return list;
}

Json speeds(const std::vector<SpeedSource>& sources) {
  Json list = Json::array();
  for (const SpeedSource& s : sources) {
    list.push_back({{"recording", s.recording},
                    {"role", to_string(s.role)},
                    {"is_logged", s.is_logged},
                    {"window_samples", s.window},
                    {"window_s", number(s.window_s)},
                    {"cut_off_Hz", number(s.cut_off_Hz)}});
  }
  return list;
}

}  // namespace tribolog::json
