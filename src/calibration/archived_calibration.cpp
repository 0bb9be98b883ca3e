#include "calibration/archived_calibration.h"

namespace tribolog::calibration {

const char* to_string(Review::Decision decision) {
  return decision == Review::Decision::approved ? "approved" : "rejected";
}

Review::Decision decision_of(const std::string& word) {
  return word == to_string(Review::Decision::approved) ? Review::Decision::approved
                                                       : Review::Decision::rejected;
}

}  // namespace tribolog::calibration
