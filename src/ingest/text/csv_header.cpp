#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "base/closest_match.h"
#include "base/utf8.h"
#include "ingest/log/units.h"
#include "ingest/text/csv_rows.h"
#include "ingest/text/fields.h"

namespace tribolog::ingest::text {
namespace {

[[noreturn]] void refuse(const Location& line, std::size_t column,
                         const InputError::Problem& problem) {
  throw InputError({line.file, line.line, static_cast<long>(column)}, problem);
}

void refuse_repeated_name(const std::vector<Field>& header, std::size_t first,
                          const Location& line) {
  for (std::size_t i = first + 1; i < header.size(); ++i) {
    if (header[i].text != header[first].text) continue;
    refuse(line, header[i].column,
           {fmt::format("column name {} stands twice, in columns {} and {}",
                        in_quotes(header[i].text), first + 1, i + 1),
            "", "",
            fmt::format("name the one that is meant by its position: \"#{}\" or \"#{}\"", first + 1,
                        i + 1)});
  }
}

std::vector<std::string> names_of(const std::vector<Field>& header) {
  std::vector<std::string> names;
  for (const Field& field : header) {
    if (!field.text.empty()) names.push_back(field.text);
  }
  return names;
}

/// 2 of "#2".
std::optional<std::size_t> position_in(const std::string& name) {
  if (name.size() < 2 || name.front() != '#') return std::nullopt;
  std::size_t position = 0;
  const auto read = std::from_chars(name.data() + 1, name.data() + name.size(), position);
  const bool is_whole = read.ec == std::errc() && read.ptr == name.data() + name.size();
  return is_whole ? std::optional(position) : std::nullopt;
}

}  // namespace

bool holds_numbers_only(const std::vector<Field>& row, DecimalMark mark) {
  bool any = false;
  for (const Field& field : row) {
    const FieldKind kind = read_number(field.text, mark).kind;
    // A time of day with its date is no column's name.
    if (kind == FieldKind::text && !read_iso_time(field.text)) return false;
    any = any || kind != FieldKind::gap;
  }
  return any;
}

bool holds_a_fraction(const std::vector<Field>& row, DecimalMark mark) {
  const char sign = mark == DecimalMark::comma ? ',' : '.';
  return std::any_of(row.begin(), row.end(), [&](const Field& field) {
    return field.text.find(sign) != std::string::npos &&
           read_number(field.text, mark).kind == FieldKind::number;
  });
}

std::vector<Field> names_by_position(std::size_t columns) {
  std::vector<Field> names;
  for (std::size_t k = 1; k <= columns; ++k) names.push_back({fmt::format("#{}", k), 1});
  return names;
}

namespace {

std::string_view without_mark(std::string_view comment) {
  const std::size_t first = comment.find_first_not_of("#%/ \t");
  return first == std::string_view::npos ? std::string_view() : comment.substr(first);
}

/// Of words with blanks between them: a clock in front, or signs that sentences lack.
bool may_be_names(const std::vector<Field>& words) {
  constexpr std::array clocks = {"t", "time", "timestamp", "stamp", "zeit", "czas", "sec"};
  std::string first = read_header_field(words.front().text).name;
  for (char& c : first) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  if (std::find(clocks.begin(), clocks.end(), first) != clocks.end()) return true;
  const auto has_sign = [](const Field& word) {
    return word.text.find_first_of("_[]0123456789") != std::string::npos;
  };
  return 2 * static_cast<std::size_t>(std::count_if(words.begin(), words.end(), has_sign)) >=
         words.size();
}

bool is_name(const Field& field) {
  return read_number(field.text).kind == FieldKind::text && !read_iso_time(field.text) &&
         !first_broken_utf8(field.text);
}

}  // namespace

std::optional<std::vector<Field>> names_in_comment(std::string_view comment, std::size_t columns,
                                                   Delimiter delimiter, const Location& line) {
  const std::string_view text = without_mark(comment);
  if (text.empty() || text.size() > longest_field_bytes) return std::nullopt;
  // "#,t,q" names all columns but the first.
  const bool is_first_unnamed = text.front() == static_cast<char>(delimiter);
  for (const Delimiter by :
       {delimiter, Delimiter::comma, Delimiter::semicolon, Delimiter::tab, Delimiter::spaces}) {
    std::vector<Field> names;
    try {
      names = split_row(text, by, line);
    } catch (const InputError&) {
      continue;
    }
    if (by == Delimiter::spaces) names = join_units(std::move(names));
    const auto first = names.begin() + (is_first_unnamed ? 1 : 0);
    if (names.size() != columns || !std::all_of(first, names.end(), is_name)) continue;
    if (by == Delimiter::spaces && !may_be_names(names)) continue;
    return names;
  }
  return std::nullopt;
}

std::string_view without_brackets(std::string_view unit) {
  const bool is_bracketed = unit.size() > 2 && ((unit.front() == '[' && unit.back() == ']') ||
                                                (unit.front() == '(' && unit.back() == ')'));
  return is_bracketed ? unit.substr(1, unit.size() - 2) : unit;
}

bool holds_units(const std::vector<Field>& row, DecimalMark mark) {
  std::size_t known = 0;
  std::size_t stated = 0;
  for (const Field& field : row) {
    if (field.text.empty() || field.text == "-") continue;
    if (read_number(field.text, mark).kind != FieldKind::text) return false;
    ++stated;
    known += log::is_known_unit(without_brackets(field.text)) ? 1 : 0;
  }
  return known > 0 && 2 * known >= stated;
}

void refuse_other_encodings(const std::vector<Field>& header, const Location& line) {
  for (const Field& field : header) {
    const auto broken = first_broken_utf8(field.text);
    if (!broken) continue;
    refuse(line, field.column + *broken,
           {"column name is not UTF-8",
            fmt::format("byte 0x{:02X}", static_cast<unsigned char>(field.text[*broken])), "",
            "Latin-1? --latin1 of inspect and init reads it; in a manifest [log] encoding = "
            "\"latin1\""});
  }
}

std::vector<std::string> repeated_names(const std::vector<Field>& header) {
  std::map<std::string_view, std::size_t> times;
  std::vector<std::string> repeated;
  for (const Field& field : header) {
    if (!field.text.empty() && ++times[field.text] == 2) repeated.push_back(field.text);
  }
  return repeated;
}

ColumnNames::ColumnNames(const std::vector<Field>& header) : header_(header) {
  for (std::size_t i = 0; i < header.size(); ++i) {
    add(header[i].text, i, by_text_);
    add(read_header_field(header[i].text).name, i, by_bare_name_);
  }
}

void ColumnNames::add(const std::string& name, std::size_t place, Index& index) {
  ++index.try_emplace(name, Places{place, 0}).first->second.count;
}

bool ColumnNames::has(const std::string& name) const {
  return by_text_.contains(name) || by_bare_name_.contains(name);
}

bool ColumnNames::has_or_counts(const std::string& name) const {
  const auto position = position_in(name);
  return has(name) || (position && *position >= 1 && *position <= header_.size());
}

std::size_t ColumnNames::find(const std::string& name, const std::string& hint_if_missing,
                              const Location& line) const {
  if (const auto exact = by_text_.find(name); exact != by_text_.end()) {
    const auto [first, count] = exact->second;
    if (count > 1) refuse_repeated_name(header_, first, line);
    return first;
  }
  const auto bare = by_bare_name_.find(name);
  const Places by_bare_name = bare == by_bare_name_.end() ? Places{} : bare->second;
  if (by_bare_name.count == 1) return by_bare_name.first;
  if (const auto position = position_in(name); position && by_bare_name.count == 0) {
    if (*position >= 1 && *position <= header_.size()) return *position - 1;
    throw InputError({line.file, line.line, 0},
                     {"there is no column " + in_quotes(name),
                      fmt::format("{} columns", header_.size()), "", hint_if_missing});
  }
  const std::vector<std::string> names = names_of(header_);
  if (by_bare_name.count > 1) {
    throw InputError({line.file, line.line, 0},
                     {"column " + in_quotes(name) + " is ambiguous", list_of_names(names), "",
                      "name it with what stands in its brackets, or by its position: \"#2\""});
  }
  std::string hint = did_you_mean(name, names);
  if (!hint.empty() && !hint_if_missing.empty()) hint += " ";
  throw InputError({line.file, line.line, 0}, {"column " + in_quotes(name) + " is missing",
                                               list_of_names(names), "", hint + hint_if_missing});
}

std::vector<Field> join_units(std::vector<Field> header) {
  std::vector<Field> joined;
  for (Field& field : header) {
    const bool is_unit =
        field.text.size() > 2 && ((field.text[0] == '[' && field.text.back() == ']') ||
                                  (field.text[0] == '(' && field.text.back() == ')'));
    if (is_unit && !joined.empty()) {
      joined.back().text += " " + field.text;
    } else {
      joined.push_back(std::move(field));
    }
  }
  return joined;
}

}  // namespace tribolog::ingest::text
