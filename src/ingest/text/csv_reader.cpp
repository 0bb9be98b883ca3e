#include "ingest/text/csv_reader.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <sys/mman.h>

#include "base/closest_match.h"
#include "base/utf8.h"
#include "ingest/text/csv_lines.h"
#include "ingest/text/csv_rows.h"
#include "ingest/text/fields.h"

namespace tribolog::ingest::text {

// Room for long columns, in pages of megabytes where the system has them: a first touch of every
// four kilobytes costs as much as reading the numbers that go there.

namespace {

/// Room for `count` values, as std::vector::reserve. Memory that is not used is not taken.
void reserve_in_large_pages(std::vector<double>& values, std::size_t count) {
  constexpr std::uintptr_t page = std::uintptr_t{1} << 21;
  values.reserve(count);
  const auto begin = reinterpret_cast<std::uintptr_t>(values.data());
  const std::uintptr_t first = (begin + page - 1) / page * page;
  const std::uintptr_t last = (begin + values.capacity() * sizeof(double)) / page * page;
  // A wish: whether the system grants it changes the speed alone.
  if (last > first) (void)madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
}

/// The names, and units from a row of their own below them.
struct Header {
  std::vector<Field> fields;
  std::string row;  ///< Empty: the log has none.
  std::vector<std::string> units;
  std::optional<EchoedJointStates> joint_states;  ///< Whose rows these are.
};

std::vector<Field> fields_of(const RowCursor& cursor, const log::LogTable& table,
                             Delimiter delimiter) {
  return split_row(cursor.row(), delimiter, {table.file, cursor.line(), 0});
}

/// Of a row that holds names or units.
std::vector<Field> words_of(const RowCursor& cursor, const CsvTable& table,
                            const TextLogRules& rules) {
  std::vector<Field> fields = fields_of(cursor, table, table.delimiter);
  if (rules.encoding == TextEncoding::utf8) return fields;
  for (Field& field : fields) field.text = utf8_of_latin1(field.text);
  return fields;
}

std::string text_in(std::string_view comment, const TextLogRules& rules) {
  return rules.encoding == TextEncoding::utf8 ? std::string(comment) : utf8_of_latin1(comment);
}

/// Names, and units below them, in the comments in front of a first row of numbers.
/// @return whether there are some.
bool read_commented_names(const RowCursor& first, std::size_t columns, const TextLogRules& rules,
                          CsvTable& table, Header& header) {
  const Location line{table.file, first.line(), 0};
  const auto& [above, last] = first.comments();
  const auto in = [&](std::string_view comment) {
    return names_in_comment(text_in(comment, rules), columns, table.delimiter, line);
  };
  auto names = in(last);
  if (names && holds_units(*names, rules.decimal_mark)) {
    const std::vector<Field> units = std::move(*names);
    names = in(above);
    if (!names) return false;
    for (const Field& unit : units) header.units.emplace_back(without_brackets(unit.text));
  }
  if (!names) return false;
  header.fields = std::move(*names);
  table.notes.push_back(Code{"reading.names_in_comment"});
  return true;
}

/// What the first rows show, the cursor standing in front of them.
std::optional<EchoedJointStates> joint_states_in(RowCursor cursor, const TextLogRules& rules,
                                                 const CsvTable& table) {
  constexpr std::size_t looked_at_rows = 200;
  std::vector<std::vector<Field>> rows;
  while (rows.size() < looked_at_rows && cursor.next() &&
         cursor.row().size() <= longest_line_bytes) {
    if (!rows.empty() && !cursor.has_line_end()) break;
    try {
      rows.push_back(words_of(cursor, table, rules));
    } catch (const InputError&) {
      return std::nullopt;  // which reading the rows tells
    }
    if (rows.size() == 1 && !EchoedJointStates::may_begin_with(rows.front())) return std::nullopt;
  }
  return EchoedJointStates::in(rows);
}

void note_repeated_names(const std::vector<Field>& header, CsvTable& table) {
  if (const auto repeated = repeated_names(header); !repeated.empty()) {
    table.notes.push_back({"reading.repeated_names", {{"columns", list_of_names(repeated)}}});
  }
}

/// Goes on to the last row of the header; stays in front of the first row where there is none.
Header read_names(RowCursor& cursor, const std::vector<log::WantedColumn>& columns,
                  const TextLogRules& rules, CsvTable& table) {
  RowCursor first = cursor;
  (void)first.next();
  const Location line{table.file, first.line(), 0};
  Header header;
  header.fields = words_of(first, table, rules);
  // A row with a number in it names no columns where a comment above it does.
  const bool has_number =
      std::any_of(header.fields.begin(), header.fields.end(), [&](const Field& field) {
        return read_number(field.text, rules.decimal_mark).kind == FieldKind::number;
      });
  if (has_number && read_commented_names(first, header.fields.size(), rules, table, header)) {
    note_repeated_names(header.fields, table);
    return header;
  }
  RowCursor second = first;
  const bool has_second = second.next() && second.row().size() <= longest_line_bytes;
  const std::vector<Field> below =
      has_second ? words_of(second, table, rules) : std::vector<Field>();
  header.joint_states = joint_states_in(cursor, rules, table);
  if (header.joint_states) {
    header.fields = header.joint_states->header();
    table.notes.push_back(Code{"reading.echoed_joint_states"});
    return header;
  }
  if (holds_numbers_only(header.fields, rules.decimal_mark) ||
      holds_a_fraction(header.fields, rules.decimal_mark)) {
    const bool by_position =
        std::all_of(columns.begin(), columns.end(),
                    [](const log::WantedColumn& c) { return c.name.starts_with('#'); });
    if (!by_position) {
      throw InputError({line.file, line.line, 1},
                       {"no column names: the first row holds numbers", "", "",
                        "put a first line with the columns' names, without '#', or ask for columns "
                        "by their position: \"#1\", \"#2\""});
    }
    header.fields = names_by_position(header.fields.size());
    table.notes.push_back(Code{"reading.columns_by_position"});
    return header;
  }
  if (table.delimiter == Delimiter::spaces) header.fields = join_units(std::move(header.fields));
  header.row = first.row();
  refuse_other_encodings(header.fields, line);
  note_repeated_names(header.fields, table);
  cursor = first;
  if (!has_second) return header;
  if (below.size() != header.fields.size() || !holds_units(below, rules.decimal_mark)) {
    return header;
  }
  for (const Field& field : below) header.units.emplace_back(without_brackets(field.text));
  table.notes.push_back(Code{"reading.units_in_second_row"});
  cursor = second;
  return header;
}

bool stands_in(const std::vector<Field>& row, const std::string& name) {
  return std::any_of(row.begin(), row.end(), [&](const Field& field) {
    return field.text == name || read_header_field(field.text).name == name;
  });
}

/// Where a column's name stands further down, if it does: other lines stand in front of the header.
std::string line_with(const std::string& name, RowCursor cursor, const CsvTable& table) {
  constexpr std::size_t looked_at = 100;
  for (std::size_t row = 0; row < looked_at && cursor.next(); ++row) {
    for (const Delimiter delimiter :
         {table.delimiter, Delimiter::comma, Delimiter::semicolon, Delimiter::tab}) {
      try {
        const auto fields = split_row(cursor.row(), delimiter, {table.file, cursor.line(), 0});
        if (fields.size() < 2 || !stands_in(fields, name)) continue;
      } catch (const InputError&) {
        continue;
      }
      return fmt::format("line {0} has it: state [log] header_line = {0} (--header-line {0})",
                         cursor.line());
    }
  }
  return "";
}

RowLayout lay_out(const Header& header, const std::vector<log::WantedColumn>& columns,
                  const TextLogRules& rules, const RowCursor& cursor, const Location& line,
                  CsvTable& table) {
  RowLayout layout;
  layout.header_row = header.row;
  layout.header = header.fields;
  layout.joint_states = header.joint_states;
  layout.mark = rules.decimal_mark;
  layout.skip_bad_rows = rules.skip_bad_rows;
  layout.slots.assign(layout.header.size(), -1);
  for (const Field& field : layout.header) table.header.push_back(field.text);
  const ColumnNames names(layout.header);
  for (const log::WantedColumn& wanted : columns) {
    if (wanted.is_optional && !names.has(wanted.name)) continue;
    const std::string elsewhere =
        names.has_or_counts(wanted.name) ? "" : line_with(wanted.name, cursor, table);
    const std::size_t index =
        names.find(wanted.name, elsewhere.empty() ? wanted.if_missing : elsewhere, line);
    if (layout.slots[index] >= 0) {
      throw InputError({table.file, line.line, static_cast<long>(layout.header[index].column)},
                       {"column " + in_quotes(wanted.name) + " is asked for twice", "", "", ""});
    }
    layout.slots[index] = static_cast<int>(table.columns.size());
    layout.readings.push_back(wanted.reading);
    log::LogColumn column;
    column.header = read_header_field(layout.header[index].text);
    column.header.place = index + 1;
    column.reading = wanted.reading;
    if (column.header.unit.empty() && !header.units.empty()) {
      column.header.unit = header.units[index];
    }
    table.columns.push_back(std::move(column));
  }
  return layout;
}

/// What the fields of a column are in the first rows.
struct Sample {
  std::size_t numbers{}, iso_times{}, times_of_day{}, dates{};
  std::set<std::string> words;  ///< That are none of these.

  [[nodiscard]] bool is_empty() const {
    return numbers + iso_times + times_of_day + dates == 0 && words.empty();
  }
  /// What all of them are; nothing where that is not one thing.
  [[nodiscard]] std::optional<log::ColumnReading> reading() const {
    const int kinds = (numbers > 0 ? 1 : 0) + (iso_times > 0 ? 1 : 0) + (times_of_day > 0 ? 1 : 0) +
                      (dates > 0 ? 1 : 0) + (words.empty() ? 0 : 1);
    if (kinds != 1) return std::nullopt;
    if (numbers > 0) return log::ColumnReading::number;
    if (iso_times > 0) return log::ColumnReading::iso_time;
    if (times_of_day > 0) return log::ColumnReading::time_of_day;
    return dates > 0 ? log::ColumnReading::date : log::ColumnReading::words;
  }
};

void count_field(const std::string& field, const TextLogRules& rules, Sample& sample) {
  const FieldKind kind = read_number(field, rules.decimal_mark).kind;
  if (kind == FieldKind::number) ++sample.numbers;
  if (kind != FieldKind::text) return;
  if (read_iso_time(field)) {
    ++sample.iso_times;
  } else if (read_time_of_day(field)) {
    ++sample.times_of_day;
  } else if (read_date(field)) {
    ++sample.dates;
  } else {
    sample.words.insert(field);
  }
}

/// Of the first rows, and of as many more as it takes until no column holds gaps alone.
std::vector<Sample> sample_rows(RowCursor cursor, const Header& header, const TextLogRules& rules,
                                const CsvTable& table) {
  constexpr std::size_t sampled_rows = 20;
  constexpr std::size_t most_rows = 100'000;
  const std::size_t columns = header.fields.size();
  std::vector<Sample> samples(columns);
  const auto is_settled = [&] {
    return std::none_of(samples.begin(), samples.end(),
                        [](const Sample& sample) { return sample.is_empty(); });
  };
  for (std::size_t row = 0; row < most_rows && cursor.next(); ++row) {
    if (row >= sampled_rows && is_settled()) break;
    if (cursor.row().size() > longest_line_bytes || !cursor.has_line_end()) break;
    std::vector<Field> fields = fields_of(cursor, table, table.delimiter);
    if (header.joint_states && !header.joint_states->lay_out(fields)) continue;
    for (std::size_t k = 0; k < std::min(columns, fields.size()); ++k) {
      count_field(fields[k].text, rules, samples[k]);
    }
  }
  return samples;
}

/// All columns that can be read, by their position; the others in a note.
std::vector<log::WantedColumn> readable_columns(const RowCursor& cursor, const Header& header,
                                                const TextLogRules& rules, CsvTable& table) {
  const std::vector<Sample> samples = sample_rows(cursor, header, rules, table);
  std::vector<log::WantedColumn> columns;
  std::vector<std::string> others;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const auto commas = std::find_if(
        samples[k].words.begin(), samples[k].words.end(), [&](const std::string& word) {
          return looks_like_decimal_comma(word) || looks_like_thousands(word, rules.decimal_mark);
        });
    if (commas != samples[k].words.end()) {
      table.notes.push_back(
          {"reading.commas_in_numbers",
           {{"column", in_quotes(header.fields[k].text)}, {"number", in_quotes(*commas)}}});
    } else if (const auto reading = samples[k].reading()) {
      columns.push_back({fmt::format("#{}", k + 1), "", *reading});
    } else if (!header.fields[k].text.empty()) {
      others.push_back(header.fields[k].text);
    }
  }
  if (!others.empty()) {
    table.notes.push_back(
        {"reading.columns_without_numbers", {{"columns", list_of_names(others)}}});
  }
  return columns;
}

/// What a reader should know of it; nothing of commas.
Statement note_of(Delimiter delimiter) {
  switch (delimiter) {
    case Delimiter::comma:
      break;
    case Delimiter::semicolon:
      return {"reading.separated_by_semicolons"};
    case Delimiter::tab:
      return {"reading.separated_by_tabs"};
    case Delimiter::spaces:
      return {"reading.separated_by_spaces"};
  }
  return {};
}

/// With decimal commas stated, commas are no delimiter, and a header with others is one name.
/// @throw InputError as refuse_commas_between_commas().
void refuse_commas_between_columns(const RowCursor& header, const CsvTable& table) {
  const bool is_one_name = fields_of(header, table, table.delimiter).size() == 1;
  if (!is_one_name || header.row().find('"') != std::string_view::npos) return;
  const std::size_t names = fields_of(header, table, Delimiter::comma).size();
  if (names > 1) {
    refuse_commas_between_commas(header.rest(), names, {table.file, header.line() + 1, 0});
  }
}

/// Rows to make room for; a guess from the first row's length, bounded by the file's size.
std::size_t likely_rows(std::string_view first_rows, std::uint64_t bytes) {
  const std::size_t first_row = std::min(first_rows.find('\n'), first_rows.size()) + 1;
  return bytes / std::max<std::size_t>(first_row, 8) + 1;
}

}  // namespace

namespace {

void pass_preamble(const Preamble& preamble, RowCursor& cursor, CsvTable& table) {
  table.notes.push_back({"reading.lines_before_table", {{"lines", preamble.line - 1}}});
  cursor.go_to_line(preamble.line, table.file);
}

Header header_of(const Preamble& preamble, const TextLogRules& rules, const Location& line,
                 CsvTable& table) {
  Header header;
  header.fields = preamble.names;
  header.units = preamble.units;
  if (rules.encoding == TextEncoding::latin1) {
    for (Field& field : header.fields) field.text = utf8_of_latin1(field.text);
  }
  refuse_other_encodings(header.fields, line);
  note_repeated_names(header.fields, table);
  return header;
}

}  // namespace

CsvTable read_csv(ByteSource& bytes, const std::string& file,
                  const std::vector<log::WantedColumn>& columns, const TextLogRules& rules) {
  TextWindow window(bytes, file);
  constexpr std::size_t first_bytes = 2 * longest_line_bytes;
  const std::string_view text = start_of_text(window.read_on({}, first_bytes), file);
  CsvTable table;
  table.file = file;
  RowCursor cursor(text);
  if (rules.header_line) {
    cursor.go_to_line(*rules.header_line, file);
    if (*rules.header_line > 1) {
      table.notes.push_back({"reading.lines_before_header", {{"lines", *rules.header_line - 1}}});
    }
  }
  const auto stated_by_log = rules.header_line ? std::nullopt : take_stated_delimiter(cursor);
  std::optional<Preamble> preamble;
  if (!rules.header_line) {
    preamble = find_preamble(cursor, file, rules.delimiter ? rules.delimiter : stated_by_log);
  }
  if (preamble) pass_preamble(*preamble, cursor, table);
  table.delimiter = rules.delimiter ? *rules.delimiter
                    : stated_by_log ? *stated_by_log
                    : preamble      ? preamble->delimiter
                                    : sniff_delimiter(cursor, file, rules.decimal_mark);
  RowCursor first = cursor;
  if (!first.next()) throw InputError({file, 0, 0}, {"no header row", "", "", ""});
  if (first.row().size() > longest_line_bytes) refuse_long_line(file, first.line());
  if (rules.decimal_mark == DecimalMark::comma && !rules.delimiter && !stated_by_log) {
    refuse_commas_between_columns(first, table);
  }
  const Header header = preamble && !preamble->names.empty()
                            ? header_of(*preamble, rules, {file, first.line(), 0}, table)
                            : read_names(cursor, columns, rules, table);
  const std::vector<log::WantedColumn> wanted =
      columns.empty() ? readable_columns(cursor, header, rules, table) : columns;
  const RowLayout layout = lay_out(header, wanted, rules, cursor, {file, first.line(), 0}, table);
  for (log::LogColumn& column : table.columns) {
    reserve_in_large_pages(column.values, likely_rows(cursor.rest(), bytes.likely_bytes()));
  }
  if (const Statement note = note_of(table.delimiter); !note.empty()) table.notes.push_back(note);
  if (rules.decimal_mark == DecimalMark::comma) {
    table.notes.push_back(Code{"reading.decimal_comma"});
  }
  cursor.go_on_in(window);
  read_rows(cursor, layout, table);
  if (cursor.mixed_line_ends()) table.notes.push_back(Code{"reading.mixed_line_ends"});
  if (table.rows == 0) {
    throw InputError({file, cursor.line(), 0}, {"no data rows", "", "", ""});
  }
  return table;
}

bool shows_decimal_commas(ByteSource& bytes, const std::string& file, const TextLogRules& rules) {
  constexpr std::size_t looked_at_bytes = std::size_t{1} << 16;
  TextWindow window(bytes, file);
  RowCursor cursor(start_of_text(window.read_on({}, looked_at_bytes), file));
  return show_decimal_commas(cursor, file, rules);
}

CsvTable read_csv(std::string_view bytes, const std::string& file,
                  const std::vector<log::WantedColumn>& columns, const TextLogRules& rules) {
  MemorySource source(bytes);
  return read_csv(source, file, columns, rules);
}

}  // namespace tribolog::ingest::text
