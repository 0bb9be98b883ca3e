// A schema that is not as tribolog makes it: one clear line, before anything else is done.

#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "archive/sample_calibration.h"
#include "archive/sqlite_place.h"
#include "base/error.h"

namespace tribolog::archive::altered_schema_test {
namespace {

const std::string edited = "PRAGMA writable_schema=1; UPDATE sqlite_master SET ";

TEST(AlteredSchema, IsRefusedByReadersAndWriters) {
  const std::string in_text = edited + "sql = replace(sql, ";
  const std::string damaged = "the archive's schema is damaged (";
  const std::vector<std::pair<std::string, std::string>> damages{
      {"DROP TABLE review", damaged + "table review is missing)"},
      {"DROP TABLE quantity", damaged + "table quantity is missing)"},
      {"DROP INDEX one_document_of_a_kind", damaged + "index one_document_of_a_kind is missing)"},
      {"DROP INDEX calibration_of_joint", damaged + "index calibration_of_joint is missing)"},
      {"ALTER TABLE calibration ADD COLUMN wind REAL",
       damaged + "table calibration is not as tribolog makes it)"},
      {"ALTER TABLE quantity DROP COLUMN words",
       damaged + "table quantity is not as tribolog makes it)"},
      {"ALTER TABLE input RENAME COLUMN role TO part",
       damaged + "table input is not as tribolog makes it)"},
      {"ALTER TABLE event RENAME TO events", damaged + "table event is missing)"},
      {"CREATE TABLE guests (name TEXT)", damaged + "table guests is none of an archive's)"},
      {"CREATE TRIGGER t AFTER INSERT ON event BEGIN DELETE FROM event; END",
       damaged + "trigger t is none of an archive's)"},
      {"CREATE VIEW v AS SELECT * FROM event", damaged + "view v is none of an archive's)"},
      {"ALTER TABLE quantity RENAME TO q; CREATE VIEW quantity AS SELECT * FROM q",
       damaged + "table quantity is missing)"},
      {in_text + "' CHECK (gear_ratio <> 0)', '')",
       damaged + "table calibration is not as tribolog makes it)"},
      {in_text + "'TEXT', 'BLOB')", damaged},
      {in_text + "' STRICT', '') WHERE name = 'document'",
       damaged + "table document is not as tribolog makes it)"},
      {edited + "sql = 'x' WHERE name = 'event'", "the archive is damaged"},
      {"PRAGMA user_version=1", damaged + "table event is not as tribolog makes it)"},
      {"PRAGMA user_version=0", "holds no tables of an archive"},
      {"PRAGMA user_version=-1", "holds no tables of an archive"},
      {"PRAGMA user_version=1000", "newer tribolog"},
      {"PRAGMA application_id=7", "of another program"},
  };
  for (const auto& [statements, says] : damages) {
    test::SqlitePlace place;
    store::open_archive(place.location(), sql::Access::write)
        .add(test::sample_calibration(1, 2, 3, 0.45), false, "2026-12-24T12:00:00Z");
    place.run(statements, false);
    for (const sql::Access access : {sql::Access::read, sql::Access::write}) {
      const std::string said = test::refusal_of<ArchiveError>([&] {
        (void)store::open_archive(place.location(), access);
        return 0;
      });
      EXPECT_NE(said.find(says), std::string::npos) << statements << ": " << said;
      EXPECT_EQ(said.find('\n'), std::string::npos) << said;
    }
    EXPECT_EQ(place.directory().entries(), 1U) << "no copy is made of what is refused";
  }
}

TEST(AlteredSchema, StatisticsAndFreePagesAreNone) {
  test::SqlitePlace place;
  store::open_archive(place.location(), sql::Access::write)
      .add(test::sample_calibration(1, 2, 3, 0.45), false, "2026-12-24T12:00:00Z");
  place.run("ANALYZE; VACUUM; CREATE TABLE x (y); DROP TABLE x", false);
  EXPECT_TRUE(
      store::open_archive(place.location(), sql::Access::read).verify("", {}).faults.empty());
}

}  // namespace
}  // namespace tribolog::archive::altered_schema_test
