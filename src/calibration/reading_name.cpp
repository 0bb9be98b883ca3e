#include "calibration/reading_name.h"

#include "base/enum_text.h"

namespace tribolog::calibration {

std::string to_string(ReadingName name) { return own_name(name); }

std::optional<method::hysteresis::Estimator> estimator_of(ReadingName name) {
  return method::hysteresis::estimator_of(to_string(name));
}

}  // namespace tribolog::calibration
