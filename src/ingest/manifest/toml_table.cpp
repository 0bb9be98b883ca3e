#include "ingest/manifest/toml_table.h"

#include <cmath>
#include <cstdlib>
#include <set>

#include <fmt/format.h>

// Bounds the recursion of parser and destructor; the files read here need 3.
#define TOML_MAX_NESTED_VALUES 32
#include <toml++/toml.h>

#include "ingest/closest_match.h"
#include "ingest/manifest/key_ranges.h"
#include "ingest/manifest/toml_precheck.h"

namespace tribolog {

struct TomlTable::View {
  std::shared_ptr<const toml::table> document;  ///< Keeps `table` alive.
  const toml::table* table{};
  std::string file;
  std::string path;  ///< "" or "joint."
  std::set<std::string> asked{};

  [[nodiscard]] const toml::node* find(const std::string& key) {
    asked.insert(key);
    return table->get(key);
  }
  /// @throw InputError where there is no such key.
  const toml::node& need(const TomlTable& self, const std::string& key, const std::string& hint);
  [[nodiscard]] TomlTable below(const toml::table& child, const std::string& key) const {
    return TomlTable(std::make_shared<View>(View{document, &child, file, path + key + "."}));
  }
};

namespace {

Location location_of(const std::string& file, const toml::source_region& region) {
  return {file, static_cast<long>(region.begin.line), static_cast<long>(region.begin.column)};
}

std::string describe(const toml::node& node) {
  if (node.as_table() != nullptr) return "a table";
  if (node.as_array() != nullptr) return "an array";
  if (const auto* text = node.as_string()) return "the text " + in_quotes(text->get());
  if (const auto* whole = node.as_integer()) return fmt::format("{}", whole->get());
  if (const auto* number = node.as_floating_point()) return fmt::format("{}", number->get());
  if (const auto* flag = node.as_boolean()) return flag->get() ? "true" : "false";
  return "a date or time";
}

std::string iso(const toml::date& date) {
  return fmt::format("{:04}-{:02}-{:02}", date.year, date.month, date.day);
}

/// Whole seconds: when a joint was measured is not known closer.
std::string iso(const toml::date_time& at) {
  std::string text = fmt::format("{}T{:02}:{:02}:{:02}", iso(at.date), at.time.hour, at.time.minute,
                                 at.time.second);
  if (!at.offset) return text;
  const int minutes = std::abs(at.offset->minutes);
  if (minutes == 0) return text + "Z";
  return text + fmt::format("{}{:02}:{:02}", at.offset->minutes < 0 ? '-' : '+', minutes / 60,
                            minutes % 60);
}

const char* expectation(Sign sign) {
  return sign == Sign::positive       ? "a number > 0"
         : sign == Sign::not_negative ? "a number >= 0"
                                      : "a finite number";
}

std::optional<double> any_number_in(const toml::node& node) {
  if (const auto* whole = node.as_integer()) return static_cast<double>(whole->get());
  if (const auto* number = node.as_floating_point()) return number->get();
  return std::nullopt;
}

/// What is wrong with a number, for the key's refusal; nothing where it can be used.
std::optional<InputError::Problem> problem_of(const toml::node& node, Sign sign,
                                              const std::string& key) {
  const auto found = any_number_in(node);
  const double value = found.value_or(0);
  const bool fits = std::isfinite(value) && !(sign == Sign::positive && value <= 0) &&
                    !(sign == Sign::not_negative && value < 0);
  if (!found || !fits) {
    return InputError::Problem{"not usable", describe(node), expectation(sign), ""};
  }
  const KeyRange range = range_of_key(key);
  if (range.holds(value)) return std::nullopt;
  return InputError::Problem{"is out of any joint's range", describe(node),
                             (sign == Sign::positive || range.smallest == 0 ? "" : "0 or ") +
                                 range.in_words() +
                                 (sign == Sign::any ? " to either side of 0" : ""),
                             "is it in another unit?"};
}

}  // namespace

TomlTable TomlTable::parse(std::string_view text, const std::string& file) {
  precheck_toml(text, file);
  try {
    auto document = std::make_shared<const toml::table>(toml::parse(text, std::string_view(file)));
    const toml::table* top = document.get();
    return TomlTable(std::make_shared<View>(View{std::move(document), top, file, ""}));
  } catch (const toml::parse_error& error) {
    throw InputError(location_of(file, error.source()),
                     {"not valid TOML: " + std::string(error.description()), "", "", ""});
  }
}

bool TomlTable::has(const std::string& key) const { return view_->find(key) != nullptr; }

bool TomlTable::has_misplaced(const std::string& key) const {
  return view_->table->get(key) != nullptr;
}

Location TomlTable::where() const { return location_of(view_->file, view_->table->source()); }

Location TomlTable::where(const std::string& key) const {
  const toml::node* node = view_->table->get(key);
  return node == nullptr ? where() : location_of(view_->file, node->source());
}

void TomlTable::refuse(const std::string& key, InputError::Problem problem) const {
  const std::string separator = problem.what.empty() || problem.what[0] == ' ' ? "" : ": ";
  problem.what = "key " + in_quotes(view_->path + key) + separator + problem.what;
  throw InputError(where(key), problem);
}

void TomlTable::refuse_unknown_keys() const {
  const std::vector<std::string> known(view_->asked.begin(), view_->asked.end());
  const toml::node* first = nullptr;
  std::string first_name;
  for (auto&& [name, value] : *view_->table) {
    if (view_->asked.count(std::string(std::string_view(name))) > 0) continue;
    const bool is_earlier =
        first == nullptr || value.source().begin.line < first->source().begin.line;
    if (is_earlier) {
      first = &value;
      first_name = std::string(std::string_view(name));
    }
  }
  if (first == nullptr) return;
  const std::string meant = did_you_mean(first_name, known);
  throw InputError(where(first_name),
                   {"unknown key " + in_quotes(view_->path + first_name), "", "",
                    meant.empty() ? "known here: " + list_of_names(known) : meant});
}

const toml::node& TomlTable::View::need(const TomlTable& self, const std::string& key,
                                        const std::string& hint) {
  if (const toml::node* node = find(key)) return *node;
  std::vector<std::string> unasked;  // one of them may be the missing one, misspelt
  for (auto&& [name, value] : *table) {
    std::string text{std::string_view(name)};
    if (asked.count(text) == 0) unasked.push_back(std::move(text));
  }
  const std::string near = closest_match(key, unasked);
  const std::string misspelt = near.empty() ? "" : "is " + in_quotes(near) + " meant to be it?";
  self.refuse(key, {" is missing", "", "", hint.empty() || !near.empty() ? misspelt : hint});
}

std::string TomlTable::text(const std::string& key, const std::string& hint) const {
  const toml::node& node = view_->need(*this, key, hint);
  const auto* text = node.as_string();
  if (text == nullptr) refuse(key, {"wrong type", describe(node), "a text", hint});
  return text->get();
}

double TomlTable::number(const std::string& key, Sign sign, const std::string& hint) const {
  const toml::node& node = view_->need(*this, key, hint);
  if (const auto problem = problem_of(node, sign, key)) refuse(key, *problem);
  return *any_number_in(node);
}

std::vector<double> TomlTable::numbers(const std::string& key, Sign sign) const {
  const toml::node& node = view_->need(*this, key, "");
  const auto* array = node.as_array();
  if (array == nullptr) refuse(key, {"wrong type", describe(node), "an array of numbers", ""});
  std::vector<double> values;
  for (const toml::node& element : *array) {
    if (auto problem = problem_of(element, sign, key)) {
      problem->what = "key " + in_quotes(view_->path + key) + ": " + problem->what;
      throw InputError(location_of(view_->file, element.source()), *problem);
    }
    values.push_back(*any_number_in(element));
  }
  return values;
}

std::vector<std::string> TomlTable::texts(const std::string& key, const std::string& hint) const {
  const toml::node& node = view_->need(*this, key, hint);
  const auto* array = node.as_array();
  if (array == nullptr) refuse(key, {"wrong type", describe(node), "an array of texts", hint});
  std::vector<std::string> values;
  for (const toml::node& element : *array) {
    const auto* text = element.as_string();
    if (text == nullptr) {
      throw InputError(location_of(view_->file, element.source()),
                       {"key " + in_quotes(view_->path + key) + ": wrong type", describe(element),
                        "a text", hint});
    }
    values.push_back(text->get());
  }
  return values;
}

TomlTable TomlTable::table(const std::string& key, const std::string& hint) const {
  const toml::node& node = view_->need(*this, key, hint);
  const auto* table = node.as_table();
  if (table == nullptr) refuse(key, {"wrong type", describe(node), "a table", hint});
  return view_->below(*table, key);
}

std::size_t TomlTable::choice(const std::string& key, const std::vector<std::string>& options,
                              const std::string& hint) const {
  const std::string expected = "one of " + list_of_names(options);
  const std::string found = text(key, hint.empty() ? expected : hint);
  for (std::size_t i = 0; i < options.size(); ++i) {
    if (options[i] == found) return i;
  }
  const std::string meant = did_you_mean(found, options);
  refuse(key, {"not known", in_quotes(found), expected, meant.empty() ? hint : meant});
}

std::string TomlTable::text_or(const std::string& key, const std::string& otherwise) const {
  return has(key) ? text(key) : otherwise;
}

std::string TomlTable::text_or_date(const std::string& key, const std::string& otherwise) const {
  const toml::node* node = view_->find(key);
  if (node == nullptr) return otherwise;
  if (const auto* date = node->as_date()) return iso(date->get());
  if (const auto* at = node->as_date_time()) return iso(at->get());
  return text(key);
}

double TomlTable::number_or(const std::string& key, double otherwise, Sign sign) const {
  return has(key) ? number(key, sign) : otherwise;
}

std::optional<double> TomlTable::find_number(const std::string& key, Sign sign) const {
  return has(key) ? std::optional(number(key, sign)) : std::nullopt;
}

bool TomlTable::flag_or(const std::string& key, bool otherwise) const {
  const toml::node* node = view_->find(key);
  if (node == nullptr) return otherwise;
  const auto* flag = node->as_boolean();
  if (flag == nullptr) refuse(key, {"wrong type", describe(*node), "true or false", ""});
  return flag->get();
}

std::uint64_t TomlTable::count_or(const std::string& key, std::uint64_t otherwise) const {
  const toml::node* node = view_->find(key);
  if (node == nullptr) return otherwise;
  const auto* whole = node->as_integer();
  if (whole == nullptr || whole->get() < 0) {
    refuse(key, {"not usable", describe(*node), "a whole number >= 0", ""});
  }
  return static_cast<std::uint64_t>(whole->get());
}

std::optional<TomlTable> TomlTable::find_table(const std::string& key) const {
  return has(key) ? std::optional(table(key)) : std::nullopt;
}

std::vector<TomlTable> TomlTable::tables(const std::string& key) const {
  const toml::node* node = view_->find(key);
  if (node == nullptr) return {};
  const auto* array = node->as_array();
  if (array == nullptr) {
    refuse(key, {"wrong type", describe(*node), "an array of tables",
                 "write [[" + view_->path + key + "]]"});
  }
  std::vector<TomlTable> tables;
  for (const toml::node& element : *array) {
    const auto* table = element.as_table();
    if (table == nullptr) {
      refuse(key,
             {"wrong type", describe(element), "a table", "write [[" + view_->path + key + "]]"});
    }
    tables.push_back(view_->below(*table, key));
  }
  return tables;
}

Location place_in_toml(std::string_view text, const std::string& file, const std::string& table,
                       const std::string& key) {
  const TomlTable top = TomlTable::parse(text, file);
  const auto found = top.one_or_more_tables(table);
  return found.empty() ? Location{file, 0, 0} : found.front().where(key);
}

std::vector<TomlTable> TomlTable::one_or_more_tables(const std::string& key) const {
  const toml::node* node = view_->find(key);
  if (node != nullptr && node->is_array()) return tables(key);
  std::vector<TomlTable> one;
  if (const auto table = find_table(key)) one.push_back(*table);
  return one;
}

}  // namespace tribolog
