#include "ingest/arrays/json_text.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>

#include <nlohmann/json.hpp>

#include "base/closest_match.h"
#include "base/error.h"
#include "ingest/arrays/array_tables.h"
#include "ingest/text/plain_json.h"

namespace tribolog::ingest::arrays {
namespace {

using text::PlainJson;

Location location_of(const PlainJson& json, std::size_t byte, const std::string& file) {
  const std::string_view before = std::string_view(json.text).substr(0, byte);
  const auto line = std::count(before.begin(), before.end(), '\n') + 1;
  const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 is 0
  const auto first = std::upper_bound(json.inserted.begin(), json.inserted.end(), line_start);
  const auto last = std::upper_bound(first, json.inserted.end(), before.size());
  return {file, line, static_cast<long>(before.size() - line_start) - (last - first)};
}

/// What is wrong, without nlohmann's prefix and position, which the location states.
std::string reason_of(const std::string& said) {
  const std::size_t colon = said.find(": ");
  return colon == std::string::npos ? said : said.substr(colon + 2);
}

class TreeBuilder : public nlohmann::json_sax<nlohmann::json> {
 public:
  TreeBuilder(const PlainJson& json, const std::string& file) : json_(json), file_(file) {}

  JsonValue take() { return std::move(root_); }

  bool null() override { return add(JsonValue()); }
  bool boolean(bool value) override { return add(JsonValue(value ? 1.0 : 0.0)); }
  bool number_integer(number_integer_t value) override { return add_integer(value); }
  bool number_unsigned(number_unsigned_t value) override { return add_integer(value); }
  bool number_float(number_float_t value, const string_t&) override {
    return add(JsonValue(value));
  }
  bool string(string_t& value) override {
    JsonValue text = compound(JsonKind::text);
    text.content->text = std::move(value);
    return add(std::move(text));
  }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return open(JsonKind::object); }
  bool start_array(std::size_t) override { return open(JsonKind::array); }
  bool end_object() override {
    keys_.pop_back();
    return close();
  }
  bool end_array() override { return close(); }
  bool key(string_t& name) override {
    if (!keys_.back().insert(name).second) {
      throw InputError({file_, 0, 0}, {"key " + in_quotes(name) + " stands twice in one object", "",
                                       "", "rename one of them"});
    }
    open_.back()->content->keys.push_back(name);
    return true;
  }
  bool parse_error(std::size_t position, const std::string& token,
                   const nlohmann::detail::exception& error) override {
    throw InputError(location_of(json_, position, file_),
                     {"no JSON: " + reason_of(error.what()), in_quotes(token), "", ""});
  }

 private:
  static JsonValue compound(JsonKind kind) {
    JsonValue value;
    value.kind = kind;
    value.content = std::make_unique<JsonContent>();
    return value;
  }
  template <class Integer>
  bool add_integer(Integer value) {
    const auto number = static_cast<double>(value);
    return add(JsonValue(number, std::abs(number) >= first_rounded_integer));
  }
  bool add(JsonValue value) {
    if (open_.empty()) {
      root_ = std::move(value);
    } else {
      open_.back()->content->elements.push_back(std::move(value));
    }
    return true;
  }
  bool open(JsonKind kind) {
    if (open_.size() == deepest_json) {
      throw InputError(
          {file_, 0, 0},
          {"JSON is nested more than " + std::to_string(deepest_json) + " deep", "", "", ""});
    }
    (void)add(compound(kind));
    // The parents do not grow while a child is open, so that their addresses hold.
    open_.push_back(open_.empty() ? &root_ : &open_.back()->content->elements.back());
    if (kind == JsonKind::object) keys_.emplace_back();
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }

  const PlainJson& json_;
  const std::string& file_;
  JsonValue root_;
  std::vector<JsonValue*> open_;
  std::vector<std::set<std::string>> keys_;
};

}  // namespace

JsonValue parse_json_text(std::string_view text, const std::string& file) {
  const PlainJson json = text::without_foreign_numbers(text);
  TreeBuilder builder(json, file);
  nlohmann::json::sax_parse(json.text, &builder);
  return builder.take();
}

}  // namespace tribolog::ingest::arrays
