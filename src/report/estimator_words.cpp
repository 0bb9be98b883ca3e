#include "report/estimator_words.h"

#include "wording/words.h"

namespace tribolog::report {

namespace {
using method::hysteresis::Estimator;
}  // namespace

std::string meaning_of(Estimator estimator) {
  return wording::words_for("estimator_meaning", to_string(estimator));
}

}  // namespace tribolog::report
