#include "ingest/dataset/log_reader.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <optional>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "base/closest_match.h"
#include "base/error.h"
#include "base/input_file.h"
#include "base/parallel_for.h"
#include "base/requirements.h"
#include "ingest/arrays/array_readers.h"
#include "ingest/dataset/companion_columns.h"
#include "ingest/dataset/found_joints.h"
#include "ingest/dataset/long_text_log.h"
#include "ingest/dataset/recording_rows.h"
#include "ingest/log/row_clock.h"
#include "ingest/log/units.h"
#include "ingest/text/csv_reader.h"
#if TRIBOLOG_LOG_FORMATS
#include "ingest/bags/bag_readers.h"
#include "ingest/measurement/measurement_readers.h"
#include "ingest/parquet/parquet_reader.h"
#endif

namespace tribolog::ingest::dataset {

namespace {

/// Index among the table's columns: by the full name, with the group in front, or without unit.
std::optional<std::size_t> index_of(const log::LogTable& table, const std::string& name) {
  std::optional<std::size_t> bare;
  for (std::size_t k = 0; k < table.columns.size(); ++k) {
    const log::ColumnHeader& header = table.columns[k].header;
    if (header.full == name || table.group + "/" + header.full == name) return k;
    if (header.name == name && !bare) bare = k;
  }
  return bare;
}

std::vector<std::string> missing_in(const log::LogTable& table,
                                    const std::vector<log::WantedColumn>& columns) {
  std::vector<std::string> missing;
  for (const log::WantedColumn& wanted : columns) {
    if (!wanted.is_optional && !index_of(table, wanted.name)) missing.push_back(wanted.name);
  }
  return missing;
}

std::vector<std::string> names_of(const log::LogTable& table) {
  std::vector<std::string> names;
  for (const log::LogColumn& column : table.columns) names.push_back(column.header.full);
  return names;
}

[[noreturn]] void refuse_missing(const std::vector<log::LogTable>& tables,
                                 const std::vector<log::WantedColumn>& columns) {
  // What is missing in the table that lacks least, of those the largest.
  const auto best = std::min_element(
      tables.begin(), tables.end(), [&](const log::LogTable& a, const log::LogTable& b) {
        const std::size_t lacks_a = missing_in(a, columns).size();
        const std::size_t lacks_b = missing_in(b, columns).size();
        return lacks_a != lacks_b ? lacks_a < lacks_b : a.columns.size() > b.columns.size();
      });
  const std::string name = missing_in(*best, columns).front();
  const std::vector<std::string> names = names_of(*best);
  std::string hint = did_you_mean(name, names);
  for (const log::WantedColumn& wanted : columns) {
    if (wanted.name == name && !wanted.if_missing.empty()) {
      hint += (hint.empty() ? "" : " ") + wanted.if_missing;
    }
  }
  const std::string where = best->group.empty() ? "" : " in " + in_quotes(best->group);
  throw InputError({best->file, 0, 0}, {"column " + in_quotes(name) + " is missing" + where,
                                        list_of_names(names), "", hint});
}

}  // namespace

log::LogFormat format_of_log(const std::string& path) {
  return log::detect_log_format(read_start(path, log::log_format_bytes), path);
}

std::vector<log::LogTable> read_tables(const std::string& path, log::LogFormat format) {
  switch (format) {
    case log::LogFormat::mat:
      return arrays::read_mat(path);
    case log::LogFormat::hdf5:
      return arrays::read_hdf5(path);
    case log::LogFormat::npz:
    case log::LogFormat::npy:
      return arrays::read_npz(path);
    case log::LogFormat::json:
      return arrays::read_bam_json(path);
#if TRIBOLOG_LOG_FORMATS
    case log::LogFormat::mcap:
      return bags::read_mcap(path);
    case log::LogFormat::rosbag:
      return bags::read_rosbag(path);
    case log::LogFormat::sqlite_bag:
      return bags::read_rosbag_db3(path);
    case log::LogFormat::mdf:
      return measurement::read_mdf(path);
    case log::LogFormat::tdms:
      return measurement::read_tdms(path);
    case log::LogFormat::parquet:
      return parquet::read_parquet(path);
#else
    case log::LogFormat::mcap:
    case log::LogFormat::rosbag:
    case log::LogFormat::sqlite_bag:
    case log::LogFormat::mdf:
    case log::LogFormat::tdms:
    case log::LogFormat::parquet:
      throw InputError({path, 0, 0}, {"is a log in a format that this program was built without",
                                      log::to_string(format), "text, MAT, HDF5, NumPy or JSON",
                                      "build it with -DTRIBOLOG_LOG_FORMATS=ON"});
#endif
    case log::LogFormat::text:
      break;
  }
  throw InputError({path, 0, 0}, {"is a text log", "", "", ""});
}

namespace {

/// Texts that are times are read as such, whatever a manifest says of them.
void refuse_other_reading(const log::WantedColumn& wanted, const log::LogColumn& column,
                          const std::string& file) {
  const auto name_of = [](log::ColumnReading reading) {
    return reading == log::ColumnReading::words ? "words" : log::unit_of_time(reading);
  };
  const std::string_view stated = name_of(wanted.reading);
  const std::string_view found = name_of(column.reading);
  if (stated == found) return;
  throw InputError({file, 0, 0},
                   {"column " + in_quotes(wanted.name) + " is read otherwise",
                    found.empty() ? "numbers" : in_quotes(found),
                    stated.empty() ? "numbers" : in_quotes(stated), "the unit in the manifest"});
}

}  // namespace

log::LogTable take_columns(std::vector<log::LogTable> tables,
                           const std::vector<log::WantedColumn>& columns) {
  std::vector<std::size_t> having;
  for (std::size_t k = 0; k < tables.size(); ++k) {
    if (missing_in(tables[k], columns).empty()) having.push_back(k);
  }
  if (having.empty()) refuse_missing(tables, columns);
  if (having.size() > 1) {
    std::vector<std::string> groups;
    for (const std::size_t k : having) groups.push_back(tables[k].group);
    throw InputError({tables[having[0]].file, 0, 0},
                     {"the columns stand in several tables", list_of_names(groups), "",
                      "put the table in front of a column's name: " +
                          in_quotes(groups[0] + "/" + columns.front().name)});
  }
  log::LogTable& table = tables[having[0]];
  if (!table.refusal.empty()) throw InputError({table.file, 0, 0}, {table.refusal, "", "", ""});
  std::vector<log::LogColumn> chosen;
  for (const log::WantedColumn& wanted : columns) {
    const auto index = index_of(table, wanted.name);
    if (!index) continue;
    chosen.push_back(table.columns[*index]);
    const bool are_names = wanted.reading == log::ColumnReading::words &&
                           chosen.back().reading == log::ColumnReading::number;
    if (are_names) chosen.back() = log::as_words(std::move(chosen.back()));
    refuse_other_reading(wanted, chosen.back(), table.file);
    if (wanted.reading == log::ColumnReading::clock) log::count_from_first(chosen.back());
  }
  table.columns = std::move(chosen);
  return std::move(table);
}

namespace {

bool is_named(const log::LogColumn& column, const log::LogTable& table, const std::string& name) {
  const log::ColumnHeader& header = column.header;
  return header.full == name || header.name == name || table.group + "/" + header.full == name ||
         (header.place > 0 && "#" + std::to_string(header.place) == name);
}

/// Takes the columns that are no part of the recording out of the table.
/// @param columns in whose order it was read; optional ones may be absent.
void set_others_apart(const std::vector<log::WantedColumn>& columns,
                      const std::vector<std::string>& others, ReadLog& read) {
  if (others.empty()) return;
  std::vector<log::LogColumn>& of_table = read.table.columns;
  auto place = of_table.begin();
  for (const log::WantedColumn& wanted : columns) {
    if (place == of_table.end()) return;
    if (wanted.is_optional && !is_named(*place, read.table, wanted.name)) continue;
    const bool is_other =
        wanted.is_optional && std::find(others.begin(), others.end(), wanted.name) != others.end();
    if (is_other) {
      read.others.emplace(wanted.name, std::move(*place));
      place = of_table.erase(place);
    } else {
      ++place;
    }
  }
}

/// Of the table that has the recording's columns.
std::vector<log::ColumnHeader> headers_of_tables(const std::vector<log::LogTable>& tables,
                                                 const std::vector<log::WantedColumn>& columns) {
  const auto table = std::find_if(tables.begin(), tables.end(), [&](const log::LogTable& one) {
    return missing_in(one, columns).empty();
  });
  return table == tables.end() ? std::vector<log::ColumnHeader>() : headers_of(*table);
}

/// Adds the angles of other joints to the columns that are read, each once.
void want_others(const std::vector<log::ColumnHeader>& header,
                 const manifest::RecordingEntry& entry, std::vector<log::WantedColumn>& columns,
                 std::vector<std::string>& others, ReadLog& read) {
  for (joint::OtherJoint& other : joints_in_columns(header, entry)) {
    const auto is_wanted = [&](const log::WantedColumn& one) { return one.name == other.angle; };
    if (std::any_of(columns.begin(), columns.end(), is_wanted)) continue;
    columns.push_back({other.angle, "", log::ColumnReading::number, true});
    others.push_back(other.angle);
    read.found_others.push_back(std::move(other));
  }
}

/// For the fingerprint: other readers open the file themselves.
void read_to_the_end(ByteSource& bytes) {
  constexpr std::size_t at_a_time = std::size_t{1} << 20;
  std::string buffer(at_a_time, '\0');
  while (bytes.read(buffer.data(), buffer.size()) > 0) {
  }
}

ReadLog read_log(const manifest::RecordingEntry& entry, const std::string& path,
                 std::vector<log::WantedColumn> columns, std::vector<std::string> others,
                 const text::TextLogRules& rules, std::vector<Statement>& notes) {
  InputFileSource log(path);
  FingerprintedSource bytes(log);
  const log::LogFormat format = format_of_log(path);
  ReadLog read;
  if (format != log::LogFormat::text) {
    std::vector<log::LogTable> tables = read_tables(path, format);
    want_others(headers_of_tables(tables, columns), entry, columns, others, read);
    read.table = take_columns(std::move(tables), columns);
  } else {
    const std::optional<text::CsvTable> first_rows = first_rows_of_text(path, rules);
    if (auto tables = read_long_text(path, first_rows, columns, rules)) {
      read.table = take_columns(std::move(*tables), columns);
    } else {
      if (first_rows) want_others(headers_of(*first_rows), entry, columns, others, read);
      read.table = text::read_csv(bytes, path, columns, rules);
    }
  }
  set_others_apart(columns, others, read);
  read_to_the_end(bytes);
  if (log.has_grown()) {
    RecordingNotes(entry.name, notes).add(Code{"reading.still_written"});
  }
  read.file.name = entry.file;
  read.file.bytes = log.bytes_read();
  read.file.sha256 = bytes.sha256();
  return read;
}

}  // namespace

KeptLogs::KeptLogs(const manifest::ManifestFile& manifest, std::filesystem::path directory)
    : directory_(std::move(directory)), rules_(manifest.text_logs) {
  for (const manifest::RecordingEntry& entry : manifest.recordings) {
    ++still_named_[entry.file];
    if (entry.columns.rows) rows_of_[entry.file].insert(entry.columns.rows->value);
    for (const manifest::RecordingEntry& companion : companions_of(entry))
      ++still_named_[companion.file];
  }
}

namespace {

/// Numbers of registers become signed ones.
void read_registers(const manifest::RecordingEntry& entry, log::LogTable& table) {
  for (const LoggedColumn& stated : logged_columns(entry.columns)) {
    const manifest::ColumnEntry& of = *stated.entry;
    if (!of.of_register) continue;
    for (log::LogColumn& column : table.columns) {
      if (!is_named(column, table, of.name)) continue;
      for (double& value : column.values) value = of.of_register->value_of(value);
    }
  }
}

/// Puts the clock of a log that has none in front of its columns.
/// @throw InputError where rows were left out: when the others were written is not known then.
void make_clock(const manifest::ColumnEntry& time, const std::string& path, log::LogTable& table) {
  const std::size_t lost = table.bad_rows + table.unclear_rows + table.remark_rows;
  if (lost > 0) {
    throw InputError({path, 0, 0},
                     {fmt::format("{} rows cannot be used, in a log without a clock", lost), "",
                      "rows without a gap, of which each is one step of the rate", ""});
  }
  table.columns.insert(table.columns.begin(), log::row_clock(present(time.rate_Hz), table.rows));
}

/// Makes one clock of what stands in two columns, or begins anew at midnight.
/// @param table the second one of two is its last column, and is taken away.
void complete_clock(const manifest::RecordingEntry& entry, log::LogTable& table,
                    std::vector<Statement>& notes) {
  if (!entry.columns.time) return;
  const manifest::ColumnEntry& time = *entry.columns.time;
  if (time.plus) {
    const log::LogColumn part = std::move(table.columns.back());
    table.columns.pop_back();
    log::add_to_clock(part, time.plus->si_factor / time.si_factor, table.columns.front());
  } else if (time.reading == log::ColumnReading::time_of_day) {
    const std::size_t midnights = log::go_on_past_midnight(table.columns.front());
    if (midnights > 0) {
      RecordingNotes(entry.name, notes).add({"reading.past_midnight", {{"midnights", midnights}}});
    }
  }
  const std::size_t back = log::go_on_past_set_back(table.columns.front());
  if (back > 0)
    RecordingNotes(entry.name, notes).add({"reading.clock_set_back", {{"times", back}}});
}

/// The rows of the joint, or of the recording, that is stated; the others are counted.
/// @param whole the column that tells them is its last one, and is left out.
ReadLog rows_of(const manifest::RecordingEntry& entry, const ReadLog& whole) {
  const manifest::RowsEntry& wanted = present(entry.columns.rows);
  const log::LogColumn& named_by = whole.table.columns.back();
  const auto word = std::find(named_by.words.begin(), named_by.words.end(), wanted.value);
  if (word == named_by.words.end()) {
    throw InputError(wanted.where, {"no row of the log is of it", in_quotes(wanted.value),
                                    "one of " + list_of_names(named_by.words), ""});
  }
  const auto place = static_cast<std::size_t>(word - named_by.words.begin());
  const std::vector<std::size_t> rows = log::rows_that_say(named_by, place);
  ReadLog part{log::with_rows(whole.table, rows), {}, whole.found_others, whole.file};
  part.table.columns.pop_back();
  for (const auto& [name, column] : whole.others) {
    part.others.emplace(name, log::with_rows(column, rows));
  }
  const bool numbers_recordings = wanted.name.starts_with("episode");
  if (numbers_recordings || !entry.columns.angle) return part;
  const auto angles = std::find_if(
      whole.table.columns.begin(), whole.table.columns.end(), [&](const log::LogColumn& column) {
        return is_named(column, whole.table, entry.columns.angle->name);
      });
  if (angles != whole.table.columns.end()) add_joints_in_rows(entry, named_by, *angles, part);
  return part;
}

}  // namespace

bool KeptLogs::holds_several(const std::string& file) const {
  const auto rows = rows_of_.find(file);
  return rows != rows_of_.end() && rows->second.size() > 1;
}

std::string KeptLogs::path_of(const manifest::RecordingEntry& entry) const {
  return (directory_ / entry.file).string();
}

void KeptLogs::read_ahead(std::span<const manifest::RecordingEntry> coming,
                          const std::vector<joint::KnownLoad>& loads,
                          const std::vector<std::string>& others) {
  constexpr std::uintmax_t small_bytes = std::uintmax_t{1} << 22;  // larger ones are read in parts
  constexpr std::uintmax_t most_bytes = std::uintmax_t{1} << 24;
  const auto is_known = [&](const std::string& file) {
    return kept_.contains(file) || ahead_.contains(file);
  };
  if (coming.empty() || is_known(coming.front().file)) return;
  std::vector<std::pair<manifest::RecordingEntry, Ahead*>> logs;
  std::uintmax_t bytes = 0;
  for (const manifest::RecordingEntry& entry : coming) {
    if (is_known(entry.file)) continue;
    if (entry.role == joint::Role::friction_points) break;
    std::error_code failure;
    const std::uintmax_t size = std::filesystem::file_size(path_of(entry), failure);
    bytes += size;
    if (failure || size > small_bytes || bytes > most_bytes) break;
    Ahead& ahead = ahead_[entry.file];
    const manifest::RecordingEntry own = without_companions(entry);
    ahead.columns = columns_wanted(own, loads, others);
    logs.emplace_back(own, &ahead);
  }
  parallel_for(logs.size(), [&](std::size_t k) {
    const auto& [entry, ahead] = logs[k];
    try {
      ahead->log = std::make_unique<ReadLog>(
          read_log(entry, path_of(entry), ahead->columns, others, rules_, ahead->notes));
    } catch (...) {
      ahead->failure = std::current_exception();
    }
  });
}

std::unique_ptr<ReadLog> KeptLogs::log_of(const manifest::RecordingEntry& entry,
                                          const std::vector<log::WantedColumn>& columns,
                                          const std::vector<std::string>& others,
                                          std::vector<Statement>& notes) {
  const auto found = ahead_.find(entry.file);
  Ahead ahead;
  if (found != ahead_.end()) {
    ahead = std::move(found->second);
    ahead_.erase(found);
  }
  if (ahead.columns != columns) {
    return std::make_unique<ReadLog>(
        read_log(entry, path_of(entry), columns, others, rules_, notes));
  }
  if (ahead.failure) std::rethrow_exception(ahead.failure);
  std::move(ahead.notes.begin(), ahead.notes.end(), std::back_inserter(notes));
  return std::move(ahead.log);
}

std::shared_ptr<const ReadLog> KeptLogs::read(const manifest::RecordingEntry& entry,
                                              const std::vector<joint::KnownLoad>& loads,
                                              std::vector<Statement>& notes,
                                              const std::vector<std::string>& others) {
  if (entry.file.find('\0') != std::string::npos) {
    throw InputError(entry.where,
                     {"NUL byte in the name of a file", in_quotes(entry.file), "", ""});
  }
  const std::string path = path_of(entry);
  std::vector<log::WantedColumn> columns = columns_wanted(entry, loads, others);
  Kept& kept = kept_[entry.file];
  const std::optional<double> rate_Hz =
      entry.columns.time ? entry.columns.time->rate_Hz : std::nullopt;
  const std::string rows = entry.columns.rows ? entry.columns.rows->value : "";
  const bool is_new = !kept.log || kept.columns != columns;
  if (is_new || kept.rate_Hz != rate_Hz || kept.rows != rows) {
    kept.log.reset();
    if (is_new || !kept.whole) {
      kept.whole.reset();
      kept.whole = log_of(entry, columns, others, notes);
    }
    ReadLog log = entry.columns.rows ? rows_of(entry, *kept.whole)
                                     : std::move(*std::exchange(kept.whole, nullptr));
    read_registers(entry, log.table);
    if (holds_several(entry.file)) {
      log.table.rows_of_others += std::exchange(log.table.other_rows, 0);
    }
    if (rate_Hz) {
      make_clock(present(entry.columns.time), path, log.table);
    } else {
      complete_clock(entry, log.table, notes);
    }
    kept.log = std::make_shared<const ReadLog>(std::move(log));
    kept.columns = std::move(columns);
    kept.rate_Hz = rate_Hz;
    kept.rows = rows;
  }
  const std::shared_ptr<const ReadLog> log = kept.log;
  if (--still_named_.at(entry.file) == 0) kept_.erase(entry.file);
  refuse_unusable_columns(entry, loads, path, log->table);
  return log;
}

}  // namespace tribolog::ingest::dataset
