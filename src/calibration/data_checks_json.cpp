// Checks on the data before any fit.

#include "calibration/parts.h"

namespace tribolog::json {

Json data_checks(const DataChecksResult& result) {
  Json list = Json::array();
  for (const DataCheck& check : result.checks) {
    list.push_back({{"name", check.name},
                    {"title", check.title},
                    {"state", to_string(check.state)},
                    {"recording", text_or_null(check.recording)},
                    {"measure", text_or_null(check.measure)},
                    {"measured", number(check.measured)},
                    {"at_least", number(check.at_least)},
                    {"at_most", number(check.at_most)},
                    {"unit", text_or_null(check.unit)},
                    {"found", text_or_null(check.found)},
                    {"consequence", text_or_null(check.consequence)},
                    {"experiment", text_or_null(check.experiment)}});
  }
  return list;
}

}  // namespace tribolog::json
