#include "ingest/manifest/toml_table.h"

#include <cmath>
#include <cstdlib>
#include <set>

#include <fmt/format.h>

#include "base/closest_match.h"
#include "ingest/manifest/gear_ratio.h"
#include "ingest/manifest/toml_document.h"

namespace tribolog::ingest::manifest {

struct TomlTable::View {
  std::shared_ptr<const TomlNode> document;  ///< Keeps `table` alive.
  const TomlNode* table{};
  std::string file;
  std::string path;  ///< "" or "joint."
  std::set<std::string> asked{};

  [[nodiscard]] const TomlNode* find(const std::string& key) {
    asked.insert(key);
    return table->member(key);
  }
  /// @throw InputError where there is no such key.
  const TomlNode& need(const TomlTable& self, const std::string& key, const std::string& hint);
  [[nodiscard]] TomlTable below(const TomlNode& child, const std::string& key) const {
    return TomlTable(std::make_shared<View>(View{document, &child, file, path + key + "."}));
  }
};

namespace {

Location location_of(const std::string& file, const TomlNode& node) {
  return {file, node.line, node.column};
}

std::string describe(const TomlNode& node) {
  if (node.as<TomlMembers>() != nullptr) return "a table";
  if (node.as<TomlArray>() != nullptr) return "an array";
  if (const auto* text = node.as<std::string>()) return "the text " + in_quotes(*text);
  if (const auto* whole = node.as<std::int64_t>()) return fmt::format("{}", *whole);
  if (const auto* number = node.as<double>()) return fmt::format("{}", *number);
  if (const auto* flag = node.as<bool>()) return *flag ? "true" : "false";
  return "a date or time";
}

const char* expectation(Sign sign) {
  return sign == Sign::positive       ? "a number > 0"
         : sign == Sign::not_negative ? "a number >= 0"
                                      : "a finite number";
}

std::optional<double> any_number_in(const TomlNode& node) {
  if (const auto* whole = node.as<std::int64_t>()) return static_cast<double>(*whole);
  if (const auto* number = node.as<double>()) return *number;
  return std::nullopt;
}

/// What is wrong with a number, for the key's refusal; nothing where it can be used.
std::optional<InputError::Problem> problem_of(const TomlNode& node, Sign sign,
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
  return of(parse_toml(text, file), file);
}

TomlTable TomlTable::of(TomlNode document, const std::string& file) {
  auto kept = std::make_shared<const TomlNode>(std::move(document));
  const TomlNode* top = kept.get();
  return TomlTable(std::make_shared<View>(View{std::move(kept), top, file, ""}));
}

bool TomlTable::has(const std::string& key) const { return view_->find(key) != nullptr; }

bool TomlTable::says(const std::string& key, std::string_view text) const {
  const TomlNode* const node = view_->find(key);
  const auto* const found = node == nullptr ? nullptr : node->as<std::string>();
  return found != nullptr && *found == text;
}

bool TomlTable::has_misplaced(const std::string& key) const {
  return view_->table->member(key) != nullptr;
}

Location TomlTable::where() const { return location_of(view_->file, *view_->table); }

Location TomlTable::where(const std::string& key) const {
  const TomlNode* node = view_->table->member(key);
  return node == nullptr ? where() : location_of(view_->file, *node);
}

void TomlTable::refuse(const std::string& key, InputError::Problem problem) const {
  const std::string separator = problem.what.empty() || problem.what[0] == ' ' ? "" : ": ";
  problem.what = "key " + in_quotes(view_->path + key) + separator + problem.what;
  throw InputError(where(key), problem);
}

void TomlTable::refuse_unknown_keys() const {
  const std::vector<std::string> known(view_->asked.begin(), view_->asked.end());
  const TomlNode* first = nullptr;
  std::string first_name;
  for (const auto& [name, value] : *view_->table->as<TomlMembers>()) {
    if (view_->asked.count(name) > 0) continue;
    if (first == nullptr || value.line < first->line) {
      first = &value;
      first_name = name;
    }
  }
  if (first == nullptr) return;
  const std::string meant = did_you_mean(first_name, known);
  throw InputError(where(first_name),
                   {"unknown key " + in_quotes(view_->path + first_name), "", "",
                    meant.empty() ? "known here: " + list_of_names(known) : meant});
}

const TomlNode& TomlTable::View::need(const TomlTable& self, const std::string& key,
                                      const std::string& hint) {
  if (const TomlNode* node = find(key)) return *node;
  std::vector<std::string> unasked;  // one of them may be the missing one, misspelt
  for (const auto& [name, value] : *table->as<TomlMembers>()) {
    if (asked.count(name) == 0) unasked.push_back(name);
  }
  const std::string near = closest_match(key, unasked);
  const std::string misspelt = near.empty() ? "" : "is " + in_quotes(near) + " meant to be it?";
  self.refuse(key, {" is missing", "", "", hint.empty() || !near.empty() ? misspelt : hint});
}

std::string TomlTable::text(const std::string& key, const std::string& hint) const {
  const TomlNode& node = view_->need(*this, key, hint);
  const auto* text = node.as<std::string>();
  if (text == nullptr) refuse(key, {"wrong type", describe(node), "a text", hint});
  return *text;
}

namespace {

/// "101:1"
double ratio_at(const TomlTable& table, const std::string& key, const std::string& text) {
  const double ratio = guarded(table, key, [&] { return parse_gear_ratio(text); });
  const KeyRange range = range_of_key(key);
  if (!range.holds(ratio)) {
    table.refuse(key, {"not usable", in_quotes(text), range.in_words(), ""});
  }
  return ratio;
}

}  // namespace

double TomlTable::number(const std::string& key, Sign sign, const std::string& hint) const {
  const TomlNode& node = view_->need(*this, key, hint);
  const auto* text = node.as<std::string>();
  const bool is_ratio = text != nullptr && key == "gear_ratio" && text->find(':') != text->npos;
  if (is_ratio) return ratio_at(*this, key, *text);
  if (const auto problem = problem_of(node, sign, key)) refuse(key, *problem);
  return *any_number_in(node);
}

std::vector<double> TomlTable::numbers(const std::string& key, Sign sign) const {
  const TomlNode& node = view_->need(*this, key, "");
  const auto* array = node.as<TomlArray>();
  if (array == nullptr) refuse(key, {"wrong type", describe(node), "an array of numbers", ""});
  std::vector<double> values;
  for (const TomlNode& element : *array) {
    if (auto problem = problem_of(element, sign, key)) {
      problem->what = "key " + in_quotes(view_->path + key) + ": " + problem->what;
      throw InputError(location_of(view_->file, element), *problem);
    }
    values.push_back(*any_number_in(element));
  }
  return values;
}

std::vector<std::string> TomlTable::texts(const std::string& key, const std::string& hint) const {
  const TomlNode& node = view_->need(*this, key, hint);
  const auto* array = node.as<TomlArray>();
  if (array == nullptr) refuse(key, {"wrong type", describe(node), "an array of texts", hint});
  std::vector<std::string> values;
  for (const TomlNode& element : *array) {
    const auto* text = element.as<std::string>();
    if (text == nullptr) {
      throw InputError(location_of(view_->file, element),
                       {"key " + in_quotes(view_->path + key) + ": wrong type", describe(element),
                        "a text", hint});
    }
    values.push_back(*text);
  }
  return values;
}

TomlTable TomlTable::table(const std::string& key, const std::string& hint) const {
  const TomlNode& node = view_->need(*this, key, hint);
  if (node.as<TomlMembers>() == nullptr) {
    refuse(key, {"wrong type", describe(node), "a table", hint});
  }
  return view_->below(node, key);
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
  const TomlNode* node = view_->find(key);
  if (node == nullptr) return otherwise;
  const auto* date = node->as<TomlDate>();
  return date != nullptr && !date->iso8601.empty() ? date->iso8601 : text(key);
}

double TomlTable::number_or(const std::string& key, double otherwise, Sign sign) const {
  return has(key) ? number(key, sign) : otherwise;
}

std::optional<double> TomlTable::find_number(const std::string& key, Sign sign) const {
  return has(key) ? std::optional(number(key, sign)) : std::nullopt;
}

bool TomlTable::flag_or(const std::string& key, bool otherwise) const {
  const TomlNode* node = view_->find(key);
  if (node == nullptr) return otherwise;
  const auto* flag = node->as<bool>();
  if (flag == nullptr) refuse(key, {"wrong type", describe(*node), "true or false", ""});
  return *flag;
}

std::uint64_t TomlTable::count_or(const std::string& key, std::uint64_t otherwise) const {
  const TomlNode* node = view_->find(key);
  if (node == nullptr) return otherwise;
  const auto* whole = node->as<std::int64_t>();
  if (whole == nullptr || *whole < 0) {
    refuse(key, {"not usable", describe(*node), "a whole number >= 0", ""});
  }
  return static_cast<std::uint64_t>(*whole);
}

std::optional<TomlTable> TomlTable::find_table(const std::string& key) const {
  return has(key) ? std::optional(table(key)) : std::nullopt;
}

std::vector<TomlTable> TomlTable::tables(const std::string& key) const {
  const TomlNode* node = view_->find(key);
  if (node == nullptr) return {};
  const auto* array = node->as<TomlArray>();
  if (array == nullptr) {
    refuse(key, {"wrong type", describe(*node), "an array of tables",
                 "write [[" + view_->path + key + "]]"});
  }
  std::vector<TomlTable> tables;
  for (const TomlNode& element : *array) {
    if (element.as<TomlMembers>() == nullptr) {
      refuse(key,
             {"wrong type", describe(element), "a table", "write [[" + view_->path + key + "]]"});
    }
    tables.push_back(view_->below(element, key));
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
  const TomlNode* node = view_->find(key);
  if (node != nullptr && node->as<TomlArray>() != nullptr) return tables(key);
  std::vector<TomlTable> one;
  if (const auto table = find_table(key)) one.push_back(*table);
  return one;
}

}  // namespace tribolog::ingest::manifest
