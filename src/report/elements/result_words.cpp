#include "report/elements/result_words.h"

#include <filesystem>

#include "wording/rounding.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::report::elements {

namespace {
using method::hysteresis::Estimator;
using wording::tr;
}  // namespace

Outcome outcome_of(calibration::Verdict verdict) {
  switch (verdict) {
    case calibration::Verdict::usable:
      return Outcome::good;
    case calibration::Verdict::doubtful:
      return Outcome::partial;
    case calibration::Verdict::not_identifiable:
      break;
  }
  return Outcome::bad;
}

std::string verdict_heading(calibration::Verdict verdict) {
  return wording::words_for("verdict_heading", to_string(verdict));
}

std::string verdict_in_words(calibration::Verdict verdict) {
  return wording::words_for("verdict_word", to_string(verdict));
}

Outcome outcome_of(statistics::StageState state) {
  switch (state) {
    case statistics::StageState::done:
      return Outcome::good;
    case statistics::StageState::partial:
      return Outcome::partial;
    case statistics::StageState::not_identifiable:
      return Outcome::bad;
    case statistics::StageState::skipped:
      break;
  }
  return Outcome::absent;
}

std::string share_in_words(double share) {
  return wording::with_unit(share < 0.01 ? "< 1" : wording::fixed(100 * share, 0), "%");
}

std::string log_name(const std::string& recording) {
  return std::filesystem::path(recording).filename().string();
}

std::string estimator_name(Estimator estimator) {
  if (const auto pair = method::hysteresis::points_of_pair(estimator)) {
    return tr("Mean of {first_point} and {second_point}",
              {{"first_point", to_string(pair->first)}, {"second_point", to_string(pair->second)}});
  }
  switch (estimator) {
    case Estimator::midline:
      return tr("Mid-line");
    case Estimator::fit:
      return tr("LuGre fit");
    case Estimator::sweep:
      return tr("Sweep");
    case Estimator::model:
      return tr("Model of sweeps and runs");
    case Estimator::stated:
      return tr("Stated");
    default:
      return tr("Point {point}", {{"point", to_string(estimator)}});
  }
}

std::string meaning_of(Estimator estimator) {
  return wording::words_for("estimator_meaning", to_string(estimator));
}

}  // namespace tribolog::report::elements
