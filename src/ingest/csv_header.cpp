#include "ingest/csv_header.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "files/utf8.h"
#include "ingest/closest_match.h"
#include "ingest/number_field.h"

namespace tribolog {
namespace {

[[noreturn]] void refuse(const Location& line, std::size_t column,
                         const InputError::Problem& problem) {
  throw InputError({line.file, line.line, static_cast<long>(column)}, problem);
}

void refuse_other_encodings(const Field& field, const Location& line) {
  const auto broken = first_broken_utf8(field.text);
  if (!broken) return;
  refuse(line, field.column + *broken,
         {"column name is not UTF-8",
          fmt::format("byte 0x{:02X}", static_cast<unsigned char>(field.text[*broken])), "",
          "convert the file: iconv -f LATIN1 -t UTF-8"});
}

std::vector<std::string> names_of(const std::vector<Field>& header) {
  std::vector<std::string> names;
  for (const Field& field : header) {
    if (!field.text.empty()) names.push_back(field.text);
  }
  return names;
}

}  // namespace

void check_header(const std::vector<Field>& header, const Location& line) {
  std::map<std::string, std::size_t> seen;
  bool all_numbers = true;
  for (std::size_t i = 0; i < header.size(); ++i) {
    const Field& field = header[i];
    refuse_other_encodings(field, line);
    all_numbers = all_numbers && read_number(field.text).kind != FieldKind::text;
    if (field.text.empty()) continue;
    const auto [first, is_new] = seen.emplace(field.text, i);
    if (is_new) continue;
    refuse(line, field.column,
           {fmt::format("column name {} stands twice, in columns {} and {}", in_quotes(field.text),
                        first->second + 1, i + 1),
            "", "", "rename one of them"});
  }
  if (all_numbers) {
    refuse(line, 1,
           {"no column names: the first row holds numbers", "", "",
            "put a first line with the columns' names, without '#'"});
  }
}

std::size_t find_column(const std::vector<Field>& header, const std::string& name,
                        const std::string& hint_if_missing, const Location& line) {
  std::vector<std::size_t> by_bare_name;
  for (std::size_t i = 0; i < header.size(); ++i) {
    if (header[i].text == name) return i;
    if (read_header_field(header[i].text).name == name) by_bare_name.push_back(i);
  }
  if (by_bare_name.size() == 1) return by_bare_name.front();
  const std::vector<std::string> names = names_of(header);
  if (by_bare_name.size() > 1) {
    throw InputError({line.file, line.line, 0},
                     {"column " + in_quotes(name) + " is ambiguous", list_of_names(names), "",
                      "name it with what stands in its brackets"});
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

}  // namespace tribolog
