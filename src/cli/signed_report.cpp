#include "cli/signed_report.h"

#include "base/error.h"
#include "report/sign_off.h"

namespace tribolog::cli {

std::string original_report(archive::CalibrationArchive& kept, const archive::Entry& entry) {
  auto bytes = kept.document(entry, archive::DocumentKind::report);
  if (!bytes) {
    throw UsageError(entry.id.substr(0, archive::shown_digits) +
                     " has no report in the archive; tribolog report --archive keeps one");
  }
  return std::move(*bytes);
}

std::string signed_report(archive::CalibrationArchive& kept, const archive::Entry& entry,
                          const std::vector<archive::Review>& further) {
  std::vector<archive::Review> reviews = kept.reviews(entry);
  reviews.insert(reviews.end(), further.begin(), further.end());
  std::string page = original_report(kept, entry);
  if (reviews.empty()) return page;
  std::vector<SignOff> decisions;
  for (const archive::Review& review : reviews) {
    decisions.push_back({review.at_utc, review.reviewer,
                         review.decision == archive::Review::Decision::approved, review.note});
  }
  return with_sign_off(page, entry.id, decisions, kept.name());
}

}  // namespace tribolog::cli
