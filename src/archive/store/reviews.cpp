// What reviewers decided.

#include <fmt/format.h>

#include "archive/store/calibration_archive.h"
#include "archive/store/digest.h"
#include "archive/store/entry_rows.h"
#include "archive/store/kept_texts.h"
#include "archive/store/schema.h"

namespace tribolog::archive {

void CalibrationArchive::add_review(const Entry& entry, const Review& review) {
  refuse_unkept_texts(std::vector<sql::Value>{review.reviewer, review.note});
  connection_->write([&] {
    const std::size_t place = reviews(entry).size();
    connection_->run(fmt::format("INSERT INTO review (calibration, place, {}) VALUES "
                                 "($1, $2, $3, $4, $5, $6)",
                                 review_columns),
                     row_of(review, entry.number, place));
    append_event("reviewed", entry.id, digest_of(entry.id, place, review), review.at_utc);
  });
}

std::vector<Review> CalibrationArchive::reviews(const Entry& entry) {
  std::vector<Review> found;
  if (version_of(*connection_) < first_schema_with_reviews) return found;
  for (const sql::Row& row :
       connection_->run(fmt::format("SELECT {} FROM review WHERE calibration = $1 ORDER BY place",
                                    review_columns),
                        {entry.number})) {
    found.push_back(review_of(row));
  }
  return found;
}

std::optional<Entry> CalibrationArchive::find_report(const std::string& sha256) {
  const sql::Rows rows = connection_->run(
      fmt::format("SELECT {} FROM calibration WHERE number IN (SELECT calibration FROM document "
                  "WHERE kind = 'report' AND sha256 = $1) ORDER BY number LIMIT 1",
                  entry_columns),
      {sha256});
  return rows.empty() ? std::nullopt : std::optional(entry_of(rows.front()));
}

}  // namespace tribolog::archive
