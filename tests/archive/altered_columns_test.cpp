// Every column of every row of every table, altered one at a time: verify notices each. The columns
// are read from the schema, so that one without cover fails here.

#include <iostream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "archive/archive_place.h"
#include "archive/sample_calibration.h"
#include "base/error.h"
#include "support/breadth.h"

namespace tribolog::archive::altered_columns_test {
namespace {

using test::AnyArchive;
using test::sample_calibration;

const std::string now = "2026-12-24T12:00:00Z";

struct Column {
  std::string table;
  std::string name;
  std::string type;  ///< As SQLite names it.
};

std::vector<Column> columns_of(sql::Dialect dialect) {
  const auto model = sql::sqlite_in_memory();
  store::create_schema(*model);
  std::vector<std::string> tables = test::tables_of_archive();
  if (dialect == sql::Dialect::sqlite) tables.emplace_back("sqlite_sequence");
  std::vector<Column> columns;
  for (const std::string& table : tables) {
    for (const sql::Row& row :
         model->run("SELECT name, type FROM pragma_table_info($1)", {table})) {
      const std::string& name = row[0].text();
      columns.push_back({table, name, name == "seq" ? "INTEGER" : row[1].text()});
    }
  }
  if (dialect == sql::Dialect::postgres) columns.push_back({"archive", "version", "INTEGER"});
  return columns;
}

/// What a column may become, in SQL: a little more, less, nothing, what another row has.
std::vector<std::string> alterations_of(const Column& column, sql::Dialect dialect) {
  const std::string& c = column.name;
  std::vector<std::string> made{"NULL", fmt::format("(SELECT max({}) FROM {})", c, column.table),
                                fmt::format("(SELECT min({}) FROM {})", c, column.table)};
  if (column.type == "BLOB") {
    made = {"NULL", dialect == sql::Dialect::sqlite ? "x'28b52ffd'" : "'\\x28b52ffd'::bytea",
            fmt::format("(SELECT {} FROM {} ORDER BY 1 LIMIT 1)", c, column.table),
            fmt::format("(SELECT {} FROM {} ORDER BY 1 DESC LIMIT 1)", c, column.table)};
  } else if (column.type == "TEXT" || column.type.empty()) {
    for (const char* const text : {"''", "'x'", "'doubtful'", "'rejected'", "'input'", "'report'",
                                   "'2026-12-24T12:00:01Z'"}) {
      made.emplace_back(text);
    }
    made.push_back(c + " || 'x'");
    made.push_back(fmt::format("'0' || substr({}, 2)", c));
    made.push_back(fmt::format("upper({})", c));
  } else {
    for (const char* const change : {"{} + 1", "{} - 1", "-{}", "{} + 100", "0", "1"}) {
      made.push_back(fmt::format(fmt::runtime(change), c));
    }
    if (column.type == "REAL") made.push_back(c + " * (1 + 1e-14)");
  }
  return made;
}

/// An archive that another program alters, and that is brought back.
class AlteredArchive {
 public:
  explicit AlteredArchive(test::ArchivePlace& place) : place_(place) {
    store::CalibrationArchive archive = store::open_archive(place.location(), sql::Access::write);
    calibration::NewCalibration first = test::sample_calibration(1, 2, 3, 0.45);
    first.facts.payload_kg = 5;
    first.facts.payload_distance_m = 0.25;
    first.facts.payload = "a box";
    first.facts.note = "warm";
    first.facts.operator_name = "A. Nowak";
    for (const calibration::Input& input : first.inputs) {
      first.documents.push_back(
          {calibration::DocumentKind::input, input.name, "log of " + input.name});
    }
    const store::Added added = archive.add(first, false, now);
    archive.add(first, true, now);
    archive.add(test::sample_calibration(1, 2, 4, 0.46), false, now);
    archive.attach_report(added.id, "<html></html>", now);
    const calibration::Entry entry = archive.find(added.id);
    archive.add_review(entry, {now, "A. Nowak", calibration::Review::Decision::approved, "good"});
    archive.add_review(entry, {now, "B. Kowal", calibration::Review::Decision::rejected, "cold"});
    place.keep();
  }

  [[nodiscard]] sql::Dialect dialect() const {
    return store::is_server(place_.location()) ? sql::Dialect::postgres : sql::Dialect::sqlite;
  }

  /// How many rows a statement changes; the database may refuse it.
  [[nodiscard]] std::size_t change(const std::string& statement) const {
    try {
      return place_.without_rules()->run(statement + " RETURNING CAST(1 AS BIGINT)").size();
    } catch (const Error&) {
      return 0;
    }
  }

  [[nodiscard]] bool is_noticed() const {
    try {
      store::CalibrationArchive archive =
          store::open_archive(place_.location(), sql::Access::read, 200);
      return !archive.verify("", {}).faults.empty();
    } catch (const Error& error) {
      EXPECT_EQ(error.status(), ExitStatus::archive_failed) << error.what();
      return error.status() == ExitStatus::archive_failed;
    }
  }

  void restore() const { place_.restore(); }

  [[nodiscard]] std::size_t rows_of(const std::string& table) const {
    const auto rows = place_.without_rules()->run("SELECT count(*) FROM " + table);
    return static_cast<std::size_t>(rows.front().front().integer());
  }

  /// " WHERE rowid = ...": of the row so far behind the first.
  [[nodiscard]] std::string at(const std::string& table, std::size_t row) const {
    return fmt::format(" WHERE {0} = (SELECT {0} FROM {1} ORDER BY 1 LIMIT 1 OFFSET {2})",
                       place_.row_id(), table, row);
  }

 private:
  test::ArchivePlace& place_;
};

TEST_P(AnyArchive, VerifyCoversEveryColumnOfEveryRow) {
  const AlteredArchive archive(*place_);
  ASSERT_FALSE(archive.is_noticed());
  const sql::Dialect dialect = archive.dialect();
  const std::string differs = dialect == sql::Dialect::sqlite ? "IS NOT" : "IS DISTINCT FROM";
  // A server takes its time to bring the tables back.
  const bool is_quick = dialect == sql::Dialect::sqlite;
  const std::size_t most_of_cell = is_quick && test::every_case() ? 100 : is_quick ? 2 : 1;
  std::size_t alterations = 0;
  for (const Column& column : columns_of(dialect)) {
    std::size_t of_column = 0;
    for (std::size_t row = 0; row < archive.rows_of(column.table); ++row) {
      std::size_t of_cell = 0;
      for (const std::string& value : alterations_of(column, dialect)) {
        if (of_cell == most_of_cell) break;
        const std::string statement =
            fmt::format("UPDATE {0} SET {1} = {2}{3} AND {1} {4} {2}", column.table, column.name,
                        value, archive.at(column.table, row), differs);
        const std::size_t changed = archive.change(statement);
        if (changed == 0) continue;
        of_column += changed;
        ++of_cell;
        EXPECT_TRUE(archive.is_noticed()) << statement;
        archive.restore();
      }
      if (of_column > 0 && !test::every_case()) break;
    }
    EXPECT_GT(of_column, 0U) << column.table << '.' << column.name << " was never altered";
    alterations += of_column;
  }
  std::cout << alterations << " alterations\n";
  EXPECT_FALSE(archive.is_noticed());
}

TEST_P(AnyArchive, VerifyNoticesRowsThatAreGoneTwiceOrSwapped) {
  const AlteredArchive archive(*place_);
  ASSERT_FALSE(archive.is_noticed());
  for (const std::string& table : test::tables_of_archive()) {
    for (std::size_t row = 0; row < archive.rows_of(table); ++row) {
      ASSERT_EQ(archive.change("DELETE FROM " + table + archive.at(table, row)), 1U);
      EXPECT_TRUE(archive.is_noticed()) << table << " without row " << row;
      archive.restore();
    }
    ASSERT_GT(archive.change("DELETE FROM " + table), 1U);
    EXPECT_TRUE(archive.is_noticed()) << table << " without rows";
    archive.restore();
  }
  struct Keyed {
    const char* table;
    const char* key;
    const char* others;
  };
  for (const auto& [table, key, others] :
       {Keyed{"quantity", "place", "calibration, name, words, unit, verdict, value, low, high"},
        Keyed{"input", "place", "calibration, name, role, bytes, sha256"},
        Keyed{"review", "place", "calibration, at_utc, reviewer, decision, note"},
        Keyed{"document", "number", "calibration, kind, name, bytes, sha256, stored_bytes"},
        Keyed{"content", "document", "zstd"},
        Keyed{"event", "number", "at_utc, what, id, digest, chain"},
        Keyed{"calibration", "number", "id"}}) {
    const bool is_copied = std::string(table) != "calibration";
    if (is_copied) {
      const std::size_t copied =
          archive.change(fmt::format("INSERT INTO {0} ({1}, {2}) SELECT {1} + 100, {2} FROM {0}{3}",
                                     table, key, others, archive.at(table, 1)));
      if (copied > 0) {
        EXPECT_TRUE(archive.is_noticed()) << table << " with a row twice";
      }
      archive.restore();
    }
    const auto move = [&, table = table, key = key](int from, int to) {
      return archive.change(
          fmt::format("UPDATE {0} SET {1} = {3} WHERE {1} = {2}", table, key, from, to));
    };
    const int first = std::string(key) == "place" ? 0 : 1;
    if (move(first, 1000) + move(first + 1, first) + move(1000, first + 1) > 0) {
      EXPECT_TRUE(archive.is_noticed()) << table << " with two rows swapped";
    }
    archive.restore();
  }
  EXPECT_FALSE(archive.is_noticed());
}

}  // namespace
}  // namespace tribolog::archive::altered_columns_test
