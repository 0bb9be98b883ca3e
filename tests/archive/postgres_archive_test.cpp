// What an archive on a server does with servers and databases that cannot serve it.

#include "archive/postgres_archive.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "archive/old_archive.h"
#include "archive/postgres_place.h"
#include "archive/sample_calibration.h"
#include "archive/sql/databases.h"
#include "archive/store/archive_location.h"
#include "archive/store/schema.h"
#include "base/error.h"
#include "base/temporary_directory.h"

namespace tribolog::archive::postgres_archive_test {
namespace {

using test::AnyArchive;
using test::PostgresArchive;
using test::PostgresPlace;
using test::PostgresServer;
using test::sample_calibration;

const std::string now = "2026-12-24T12:00:00Z";

INSTANTIATE_TEST_SUITE_P(
    Postgres, AnyArchive,
    testing::Values([](std::string& why) -> std::unique_ptr<test::ArchivePlace> {
      why = test::PostgresServer::of_this_program().why_not();
      if (!why.empty()) return nullptr;
      return std::make_unique<test::PostgresPlace>();
    }));

TEST_F(PostgresArchive, SaysInOneLineWhyThereIsNoConnection) {
  constexpr ExitStatus failed = ExitStatus::archive_failed;
  const std::string uri = server_.new_database();
  const std::string password = test::PostgresServer::password_in_uri();
  const std::string port = uri.substr(uri.rfind(':') + 1, uri.rfind('/') - uri.rfind(':') - 1);
  expect(refusal(replaced(uri, password, "wrong")), failed, "password authentication failed");
  expect(refusal(replaced(uri, ":" + password, "")), failed, "no password supplied");
  expect(refusal(replaced(uri, ":" + port, ":1")), failed, "Connection refused");
  expect(refusal(server_.uri("none")), failed, "database \"none\" does not exist");
  expect(refusal("postgresql://127.0.0.1:1/none"), failed, "postgresql://127.0.0.1:1/none");
}

TEST_F(PostgresArchive, RefusesAStringFromWhichAPasswordCouldShow) {
  for (const char* const uri :
       {"postgresql://u:sec@ret@host/db", "postgresql://u:sec/ret@host/db",
        "postgresql://u:sec?ret@host/db", "postgresql://u:sec%zzret@host/db",
        "postgresql://u@host/db?nosuch=secret", "postgresql://u:secret@host:12secret/db",
        "postgresql://[secret/db"}) {
    const Refusal refused = refusal(uri);
    expect(refused, ExitStatus::usage, "connection string cannot be read");
    for (const char* const part : {"sec", "ret"}) {
      EXPECT_EQ(replaced(refused.words, "characters", "").find(part), std::string::npos)
          << refused.words;
    }
  }
}

TEST_F(PostgresArchive, ShowsItsNameWithoutThePassword) {
  const std::string uri = server_.new_database();
  const std::string shown = replaced(uri, ":" + test::PostgresServer::password_in_uri(), "");
  EXPECT_EQ(store::open_archive(uri, sql::Access::write).name(), shown);
}

TEST_F(PostgresArchive, ReadOnlyIsAnOutputErrorAndChangesNothing) {
  const std::string uri = server_.new_database();
  store::open_archive(uri, sql::Access::write)
      .add(test::sample_calibration(1, 2, 3, 0.45), false, now);
  store::CalibrationArchive earlier = store::open_archive(uri, sql::Access::write);
  const std::string name = uri.substr(uri.rfind('/') + 1);
  server_.run("ALTER DATABASE " + name + " SET default_transaction_read_only = on", uri);
  expect(refusal(uri), ExitStatus::output_failed, "read-only");
  EXPECT_EQ(store::open_archive(uri, sql::Access::read).list({}).size(), 1U);
  EXPECT_TRUE(store::open_archive(uri, sql::Access::read).verify("", {}).faults.empty());
}

TEST_F(PostgresArchive, WhoMayNotWriteReadsAndIsToldSo) {
  const std::string uri = server_.new_database();
  store::open_archive(uri, sql::Access::write)
      .add(test::sample_calibration(1, 2, 3, 0.45), false, now);
  server_.run(
      "CREATE ROLE reader LOGIN PASSWORD 'r'; GRANT SELECT ON ALL TABLES IN SCHEMA public "
      "TO reader",
      uri);
  const std::string as_reader =
      replaced(uri, "tribolog:" + test::PostgresServer::password_in_uri(), "reader:r");
  EXPECT_EQ(store::open_archive(as_reader, sql::Access::read).list({}).size(), 1U);
  store::CalibrationArchive archive = store::open_archive(as_reader, sql::Access::write);
  expect(refusal_of([&] { archive.add(test::sample_calibration(1, 2, 4, 0.45), false, now); }),
         ExitStatus::output_failed, "permission denied");
  EXPECT_EQ(archive.list({}).size(), 1U);
}

TEST_F(PostgresArchive, SaysThatAnotherProcessHasLockedIt) {
  const std::string uri = server_.new_database();
  store::CalibrationArchive waiting = store::open_archive(uri, sql::Access::write, 300);
  const auto holder = sql::open_postgres(uri, sql::Access::write, 300);
  holder->write([&] {
    expect(refusal_of([&] { waiting.add(test::sample_calibration(1, 2, 3, 0.45), false, now); }),
           ExitStatus::archive_failed, "locked by another process, for more than 0.3 s");
    store::CalibrationArchive at_once = store::open_archive(uri, sql::Access::write, 0);
    expect(refusal_of([&] { at_once.add(test::sample_calibration(1, 2, 3, 0.45), false, now); }),
           ExitStatus::archive_failed, "locked by another process");
    EXPECT_TRUE(waiting.list({}).empty()) << "a reader waits for no writer";
  });
  EXPECT_TRUE(waiting.add(test::sample_calibration(1, 2, 3, 0.45), false, now).is_new);
}

const std::string cut_all_others =
    "SELECT pg_terminate_backend(pid, 10000) FROM pg_stat_activity "
    "WHERE datname = current_database() AND pid <> pg_backend_pid()";

TEST_F(PostgresArchive, SaysThatTheConnectionWasLostAndKeepsNothingHalf) {
  const std::string uri = server_.new_database();
  store::open_archive(uri, sql::Access::write);
  const auto connection = sql::open_postgres(uri, sql::Access::write, 300);
  expect(refusal_of([&] {
           connection->write([&] {
             connection->run("INSERT INTO event VALUES (1, '', 'added', '', '', $1)",
                             {std::string(64, '0')});
             server_.run(cut_all_others, uri);
             connection->run("SELECT count(*) FROM event");
           });
         }),
         ExitStatus::archive_failed, "the connection to the server was lost");
  EXPECT_EQ(server_.run("SELECT count(*) FROM event", uri), "0");
}

TEST_F(PostgresArchive, AConnectionThatWasCutMeanwhileIsMadeAgain) {
  const std::string uri = server_.new_database();
  store::CalibrationArchive archive = store::open_archive(uri, sql::Access::write);
  server_.run(cut_all_others, uri);
  EXPECT_TRUE(archive.add(test::sample_calibration(1, 2, 3, 0.45), false, now).is_new);
  server_.run(cut_all_others, uri);
  EXPECT_TRUE(archive.verify("", {}).faults.empty());
  EXPECT_EQ(archive.list({}).size(), 1U);
}

TEST_F(PostgresArchive, ANewerSchemaAndOtherTablesAreLeftAlone) {
  const std::string newer = server_.new_database();
  store::open_archive(newer, sql::Access::write);
  server_.run("UPDATE archive SET version = 7", newer);
  expect(refusal(newer), ExitStatus::archive_failed, "newer tribolog");
  const std::string other = server_.new_database();
  server_.run("CREATE TABLE document (x int)", other);
  expect(refusal(other), ExitStatus::archive_failed, "another program's tables");
  EXPECT_EQ(server_.run("SELECT count(*) FROM pg_tables WHERE schemaname = 'public'", other), "1");
  server_.run("CREATE TABLE archive (x int)", other);
  expect(refusal(other), ExitStatus::archive_failed, "damaged");
}

TEST_F(PostgresArchive, IsBroughtUpToDateWhollyOrNotAtAll) {
  const std::string uri = server_.new_database();
  store::open_archive(uri, sql::Access::write)
      .add(test::sample_calibration(1, 2, 3, 0.45), false, now);
  const auto connection = sql::open_postgres(uri, sql::Access::write, 300);
  const store::UpgradeStep adds = [](sql::Connection& c) {
    c.run_script("ALTER TABLE calibration ADD COLUMN site TEXT NOT NULL DEFAULT 'here'");
  };
  const store::UpgradeStep fails = [](sql::Connection&) { throw ArchiveError("no further"); };
  std::vector<store::UpgradeStep> steps = store::upgrade_steps();
  steps.push_back(adds);
  steps.push_back(fails);
  EXPECT_THROW(store::upgrade(*connection, steps), ArchiveError);
  EXPECT_EQ(store::version_of(*connection), store::schema_version);
  EXPECT_TRUE(store::open_archive(uri, sql::Access::read).verify("", {}).faults.empty());
  steps.pop_back();
  EXPECT_EQ(store::upgrade(*connection, steps), store::schema_version);
  EXPECT_EQ(store::version_of(*connection), store::schema_version + 1);
  EXPECT_EQ(connection->run("SELECT site FROM calibration").front().front().text(), "here");
  expect(refusal(uri), ExitStatus::archive_failed, "newer tribolog");
}

/// An older program's archive, moved to the server: the same rows in the same tables.
void move_archive_of_schema_2(const std::string& uri) {
  const test::TemporaryDirectory directory;
  const std::string path = directory.path("a.tribolog");
  test::make_archive_of_schema_2(path);
  const auto from = sql::open_sqlite(path, sql::Access::read, 300);
  const auto to = sql::open_postgres(uri, sql::Access::write, 300);
  to->write([&] {
    store::create_schema(*to, 2);
    to->run_script(
        "ALTER TABLE calibration ALTER number SET GENERATED BY DEFAULT; ALTER TABLE document ALTER "
        "number SET GENERATED BY DEFAULT");
    for (const std::string& table : test::tables_of_archive()) {
      std::string columns;
      std::string places;
      std::size_t count = 0;
      for (const sql::Row& row : from->run("SELECT name FROM pragma_table_info($1)", {table})) {
        columns += (count == 0 ? "" : ", ") + row.front().text();
        places += fmt::format("{}${}", count == 0 ? "" : ", ", count + 1);
        ++count;
      }
      for (const sql::Row& row : from->run("SELECT " + columns + " FROM " + table)) {
        to->run("INSERT INTO " + table + " (" + columns + ") VALUES (" + places + ")", row);
      }
    }
    to->run_script(
        "ALTER TABLE calibration ALTER number SET GENERATED ALWAYS, ALTER number RESTART WITH 10; "
        "ALTER TABLE document ALTER number SET GENERATED ALWAYS, ALTER number RESTART WITH 10");
  });
}

TEST_F(PostgresArchive, Schema2IsProvenByItsOwnDigestsBeforeAndAfter) {
  const std::string uri = server_.new_database();
  move_archive_of_schema_2(uri);
  EXPECT_TRUE(store::open_archive(uri, sql::Access::read)
                  .verify(test::head_of_schema_2, {})
                  .faults.empty());
  store::CalibrationArchive archive = store::open_archive(uri, sql::Access::write);
  EXPECT_EQ(server_.run("SELECT version FROM archive", uri), std::to_string(store::schema_version));
  archive.add(test::sample_calibration(1, 2, 3, 0.45), false, now);
  EXPECT_TRUE(archive.verify(test::head_of_schema_2, {}).faults.empty());
}

TEST_F(PostgresArchive, Schema1TakesReviewsOnceItIsWritten) {
  const std::string uri = server_.new_database();
  move_archive_of_schema_2(uri);
  server_.run(
      "DELETE FROM event WHERE what = 'reviewed'; DROP TABLE review; ALTER TABLE event DROP "
      "CONSTRAINT event_what_check; ALTER TABLE event ADD CONSTRAINT event_what_check CHECK (what "
      "IN ('added', 'report', 'removed')); UPDATE archive SET version = 1",
      uri);
  store::CalibrationArchive archive = store::open_archive(uri, sql::Access::write);
  const calibration::Entry entry = archive.list({}).front();
  archive.add_review(entry,
                     {now, "A. Reviewer", calibration::Review::Decision::rejected, "too warm"});
  EXPECT_EQ(archive.reviews(entry).size(), 1U);
  EXPECT_TRUE(archive.verify("", {}).faults.empty());
}

TEST_F(PostgresArchive, ADamagedSchemaIsRefused) {
  for (const char* const statement :
       {"DROP TABLE review", "DROP INDEX document_of_calibration",
        "ALTER TABLE calibration ADD COLUMN wind text", "ALTER TABLE quantity DROP COLUMN words",
        "ALTER TABLE quantity ALTER COLUMN words DROP NOT NULL",
        "ALTER TABLE quantity ALTER COLUMN words TYPE varchar(99)",
        "ALTER TABLE calibration DROP CONSTRAINT calibration_gear_ratio_check",
        "ALTER TABLE quantity DROP CONSTRAINT quantity_calibration_fkey",
        "CREATE FUNCTION f() RETURNS trigger LANGUAGE plpgsql AS 'BEGIN RETURN NULL; END'; "
        "CREATE TRIGGER t BEFORE INSERT ON event FOR EACH ROW EXECUTE FUNCTION f()",
        "CREATE RULE r AS ON INSERT TO event DO INSTEAD NOTHING",
        "ALTER TABLE event ENABLE ROW LEVEL SECURITY",
        "ALTER TABLE review RENAME TO r2; CREATE VIEW review AS SELECT * FROM r2",
        "INSERT INTO archive VALUES (3)", "DELETE FROM archive"}) {
    const std::string uri = server_.new_database();
    store::open_archive(uri, sql::Access::write)
        .add(test::sample_calibration(1, 2, 3, 0.45), false, now);
    server_.run(statement, uri);
    for (const sql::Access access : {sql::Access::read, sql::Access::write}) {
      expect(refusal(uri, access), ExitStatus::archive_failed, "schema is damaged");
    }
  }
}

TEST_F(PostgresArchive, TakesNoDatabaseInAnotherEncoding) {
  const std::string latin1 = server_.new_database("ENCODING 'LATIN1' TEMPLATE template0");
  expect(refusal(latin1), ExitStatus::archive_failed, "LATIN1");
}

TEST_F(PostgresArchive, IsOnTheDiskBeforeItIsAcknowledged) {
  const std::string uri = server_.new_database();
  const std::string name = uri.substr(uri.rfind('/') + 1);
  server_.run("ALTER DATABASE " + name + " SET synchronous_commit = off", uri);
  const auto connection = sql::open_postgres(uri, sql::Access::write, 300);
  EXPECT_EQ(connection->run("SHOW synchronous_commit").front().front().text(), "on");
}

TEST_F(PostgresArchive, KeepsTwoArchivesOfOneDatabaseApart) {
  const std::string uri = server_.new_database();
  server_.run("CREATE SCHEMA cell_b", uri);
  const std::string other = uri + "?options=-csearch_path%3Dcell_b";
  store::open_archive(uri, sql::Access::write)
      .add(test::sample_calibration(1, 2, 3, 0.45), false, now);
  EXPECT_TRUE(store::open_archive(other, sql::Access::write).list({}).empty());
  EXPECT_EQ(store::open_archive(uri, sql::Access::read).list({}).size(), 1U);
}

TEST_F(PostgresArchive, BackupIsLeftToPgDump) {
  EXPECT_THROW(store::open_archive(server_.new_database(), sql::Access::write).backup("/nowhere"),
               UsageError);
}

}  // namespace
}  // namespace tribolog::archive::postgres_archive_test
