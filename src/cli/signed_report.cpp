#include "cli/signed_report.h"

#include "base/error.h"
#include "report/sign_off.h"

namespace tribolog::cli {

std::string original_report(archive::store::CalibrationArchive& kept,
                            const calibration::Entry& entry) {
  auto bytes = kept.document(entry, calibration::DocumentKind::report);
  if (!bytes) {
    throw UsageError(entry.id.substr(0, calibration::shown_digits) +
                     " has no report in the archive; tribolog report --archive keeps one");
  }
  return std::move(*bytes);
}

std::string signed_report(archive::store::CalibrationArchive& kept, const calibration::Entry& entry,
                          const std::vector<calibration::Review>& further) {
  std::vector<calibration::Review> reviews = kept.reviews(entry);
  reviews.insert(reviews.end(), further.begin(), further.end());
  std::string page = original_report(kept, entry);
  if (reviews.empty()) return page;
  std::vector<report::SignOff> decisions;
  for (const calibration::Review& review : reviews) {
    decisions.push_back({review.at_utc, review.reviewer,
                         review.decision == calibration::Review::Decision::approved, review.note});
  }
  return report::with_sign_off(page, entry.id, decisions, kept.name());
}

}  // namespace tribolog::cli
