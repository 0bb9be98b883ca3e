#pragma once
// Where a test keeps an archive: what holds of one holds of the other.

#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "archive/sql/databases.h"
#include "archive/store/archive_location.h"
#include "archive/store/schema.h"

namespace tribolog::test {

/// An archive of its own for each test; not made yet.
class ArchivePlace {
 public:
  virtual ~ArchivePlace() = default;
  /// As after --archive.
  [[nodiscard]] virtual std::string location() const = 0;
  /// Statements as another program would run them. Rows that belong to others go with those
  /// (ON DELETE CASCADE) only where `cascades`.
  virtual void run(const std::string& statements, bool cascades) = 0;
  /// An archive that is not made yet again.
  virtual void start_again() = 0;
  /// Keeps what the archive's tables hold now, and brings it back.
  virtual void keep() = 0;
  virtual void restore() = 0;
  /// A connection on which the database's own rules are switched off as far as they can be.
  [[nodiscard]] virtual std::unique_ptr<archive::sql::Connection> without_rules() const = 0;
  /// By which a table's row is told from others: "rowid".
  [[nodiscard]] virtual std::string row_id() const = 0;
};

/// The tables of an archive, as the schema that makes them names them.
inline std::vector<std::string> tables_of_archive() {
  const auto model = archive::sql::sqlite_in_memory();
  archive::store::create_schema(*model);
  std::vector<std::string> tables;
  for (const archive::sql::Row& row :
       model->run("SELECT name FROM sqlite_master WHERE type = 'table' AND name NOT LIKE "
                  "'sqlite%' ORDER BY rowid")) {
    tables.push_back(row.front().text());
  }
  return tables;
}

/// Makes a place. @return nothing where there can be none; `why` says it.
using MakePlace = std::unique_ptr<ArchivePlace> (*)(std::string& why);

class AnyArchive : public testing::TestWithParam<MakePlace> {
 protected:
  void SetUp() override {
    std::string why;
    place_ = GetParam()(why);
    if (!place_) GTEST_SKIP() << why;
  }
  [[nodiscard]] archive::store::CalibrationArchive open(
      archive::sql::Access access = archive::sql::Access::write) const {
    return archive::store::open_archive(place_->location(), access, 200);
  }
  [[nodiscard]] std::vector<std::string> faults(const std::string& head = "") const {
    return open(archive::sql::Access::read).verify(head, {}).faults;
  }
  std::unique_ptr<ArchivePlace> place_;
};

}  // namespace tribolog::test
