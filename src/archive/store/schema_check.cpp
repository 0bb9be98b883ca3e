#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "archive/sql/databases.h"
#include "archive/store/schema.h"
#include "base/error.h"

namespace tribolog::archive::store {
namespace {

using sql::Row;
using sql::Rows;

/// "table quantity", and what it is made of, in words that can be compared.
using Parts = std::map<std::string, std::string>;

std::string without_blanks(std::string text) {
  text.erase(std::remove_if(text.begin(), text.end(),
                            [](char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r'; }),
             text.end());
  return text;
}

/// SQLite's own tables and indices come with those of the archive, but for statistics, which change
/// no answer.
Parts parts_of_sqlite(sql::Connection& connection) {
  Parts parts;
  for (const Row& row :
       connection.run("SELECT type, name, tbl_name, COALESCE(sql, '') FROM sqlite_master "
                      "WHERE name NOT LIKE 'sqlite_stat_' ORDER BY name")) {
    parts[row[0].text() + " " + row[1].text()] =
        row[2].text() + ":" + without_blanks(row[3].text());
  }
  return parts;
}

std::string server_type(const std::string& sqlite_type) {
  if (sqlite_type == "INTEGER") return "bigint";
  if (sqlite_type == "REAL") return "double precision";
  return sqlite_type == "BLOB" ? "bytea" : "text";
}

/// Names without quotes are in small letters there.
std::string as_the_server_folds(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c | 0x20) : c; });
  return name;
}

std::int64_t count_of(const std::string& text, const std::string& word) {
  std::int64_t count = 0;
  for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos; ++at) ++count;
  return count;
}

std::string rules_in_words(std::int64_t checks, std::int64_t references, std::int64_t keys) {
  return fmt::format("{} checks, {} references, {} keys", checks, references, keys);
}

/// What a server's tables have to be, from those that the same statements make in SQLite.
Parts expected_on_server(sql::Connection& model) {
  Parts parts;
  for (const Row& table : model.run("SELECT name, sql FROM sqlite_master WHERE type = 'table' AND "
                                    "name NOT LIKE 'sqlite%'")) {
    const std::string& name = table[0].text();
    const std::string& text = table[1].text();
    parts["table " + name] =
        rules_in_words(count_of(text, "CHECK"), count_of(text, "REFERENCES"),
                       count_of(text, "PRIMARY KEY") + count_of(text, "UNIQUE"));
    for (const Row& column :
         model.run("SELECT name, type, \"notnull\", pk FROM pragma_table_info($1)", {name})) {
      const bool is_needed = column[2].integer() != 0 || column[3].integer() != 0;
      parts["column " + name + "." + as_the_server_folds(column[0].text())] =
          server_type(column[1].text()) + (is_needed ? " NOT NULL" : "");
    }
  }
  parts["table archive"] = rules_in_words(0, 0, 0);
  parts["column archive.version"] = "bigint NOT NULL";
  for (const char* const index : {"document_of_calibration", "one_document_of_a_kind",
                                  "calibration_of_robot", "calibration_of_serial"}) {
    parts[std::string("index ") + index] = "";
  }
  return parts;
}

/// Of the tables that an archive has; others in the same place are another program's.
Parts parts_of_server(sql::Connection& connection, const Parts& expected) {
  Parts parts;
  const auto is_ours = [&](const std::string& table) {
    return expected.count("table " + table) > 0;
  };
  const auto add = [&](const Row& row, const char* kind, const std::string& name,
                       const std::string& words) {
    if (is_ours(row[0].text())) parts[std::string(kind) + " " + name] = words;
  };
  const std::string here =
      " FROM pg_class c JOIN pg_namespace n ON n.oid = c.relnamespace AND n.nspname = "
      "current_schema() ";
  const auto rules = [](const char* kinds) {
    return fmt::format(
        "(SELECT count(*) FROM pg_constraint k WHERE k.conrelid = c.oid AND k.contype IN ({}))",
        kinds);
  };
  for (const Row& row :
       connection.run("SELECT CAST(c.relname AS TEXT), " + rules("'c'") + ", " + rules("'f'") +
                      ", " + rules("'p', 'u'") + here +
                      "WHERE c.relkind = 'r' AND NOT c.relrowsecurity AND NOT c.relhasrules")) {
    add(row, "table", row[0].text(),
        rules_in_words(row[1].integer(), row[2].integer(), row[3].integer()));
  }
  for (const Row& row : connection.run(
           "SELECT CAST(c.relname AS TEXT), CAST(a.attname AS TEXT), "
           "CAST(format_type(a.atttypid, a.atttypmod) AS TEXT), CAST(a.attnotnull AS TEXT)" +
           here +
           "JOIN pg_attribute a ON a.attrelid = c.oid AND a.attnum > 0 AND NOT a.attisdropped "
           "WHERE c.relkind = 'r'")) {
    add(row, "column", row[0].text() + "." + row[1].text(),
        row[2].text() + (row[3].text() == "true" ? " NOT NULL" : ""));
  }
  for (const Row& row : connection.run(
           "SELECT CAST(c.relname AS TEXT), CAST(i.relname AS TEXT)" + here +
           "JOIN pg_index x ON x.indrelid = c.oid JOIN pg_class i ON i.oid = x.indexrelid WHERE "
           "x.indisvalid AND NOT EXISTS (SELECT 1 FROM pg_constraint k WHERE k.conindid = "
           "i.oid)")) {
    add(row, "index", row[1].text(), "");
  }
  for (const Row& row :
       connection.run("SELECT CAST(c.relname AS TEXT), CAST(t.tgname AS TEXT)" + here +
                      "JOIN pg_trigger t ON t.tgrelid = c.oid AND NOT "
                      "t.tgisinternal")) {
    add(row, "trigger", row[1].text(), "");
  }
  return parts;
}

/// A table that is missing is named before its columns and indices.
std::vector<std::string> tables_first(const Parts& parts) {
  std::vector<std::string> names;
  for (const auto& [part, words] : parts) names.push_back(part);
  std::stable_partition(names.begin(), names.end(),
                        [](const std::string& part) { return part.starts_with("table "); });
  return names;
}

void refuse_differences(const Parts& found, const Parts& expected, const std::string& name) {
  const auto refuse = [&](const std::string& part, const char* what) {
    throw ArchiveError(fmt::format(
        "{}: the archive's schema is damaged ({} {}); it is left as it is; restore a backup",
        printable(name, longest_path), printable(part), what));
  };
  for (const std::string& part : tables_first(expected)) {
    const auto at = found.find(part);
    if (at == found.end()) refuse(part, "is missing");
    if (at->second != expected.at(part)) refuse(part, "is not as tribolog makes it");
  }
  for (const std::string& part : tables_first(found)) {
    if (expected.count(part) == 0) refuse(part, "is none of an archive's");
  }
}

}  // namespace

void refuse_damaged_schema(sql::Connection& connection, int version) {
  const auto model = sql::sqlite_in_memory();
  create_schema(*model, version);
  if (connection.dialect() == sql::Dialect::sqlite) {
    refuse_differences(parts_of_sqlite(connection), parts_of_sqlite(*model), connection.name());
  } else {
    const Parts expected = expected_on_server(*model);
    refuse_differences(parts_of_server(connection, expected), expected, connection.name());
  }
}

}  // namespace tribolog::archive::store
