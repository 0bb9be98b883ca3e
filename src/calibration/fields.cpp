#include "calibration/fields.h"

#include "wording/words.h"

namespace tribolog::calibration {
namespace {

constexpr const char* number_or_null = R"({"type": ["number", "null"]})";
constexpr const char* list_of_numbers =
    R"({"type": "array", "items": {"type": ["number", "null"]}})";
constexpr const char* list_of_texts = R"({"type": "array", "items": {"type": "string"}})";
constexpr const char* code = R"({"$ref": "#/$defs/code"})";

Json or_null(Json schema) {
  return {{"oneOf", Json::array({{{"type", "null"}}, std::move(schema)})}};
}

}  // namespace

void Fields::flag(const char* key, bool value, const char* meaning) {
  put(key, Json(value), R"({"type": "boolean"})", meaning);
}

void Fields::flag(const char* key, std::optional<bool> value, const char* meaning) {
  put(key, value ? Json(*value) : Json(nullptr), R"({"type": ["boolean", "null"]})", meaning);
}

void Fields::number(const char* key, double value, const char* meaning) {
  put(key, calibration::number(value), number_or_null, meaning);
}

void Fields::number(const char* key, const std::optional<double>& value, const char* meaning) {
  put(key, calibration::number(value), number_or_null, meaning);
}

void Fields::known_number(const char* key, double value, const char* meaning) {
  put(key, calibration::number(value), R"({"type": "number"})", meaning);
}

void Fields::numbers(const char* key, const std::vector<double>& values, const char* meaning) {
  put(key, calibration::numbers(values), list_of_numbers, meaning);
}

void Fields::text(const char* key, const std::string& text, const char* meaning) {
  put(key, Json(text), R"({"type": "string"})", meaning);
}

void Fields::text_or_null(const char* key, const std::string& text, const char* meaning) {
  put(key, calibration::text_or_null(text), R"({"type": ["string", "null"]})", meaning);
}

void Fields::texts(const char* key, const std::vector<std::string>& texts, const char* meaning) {
  put(key, Json(texts), list_of_texts, meaning);
}

void Fields::words(const char* key, const Statement& statement, const char* meaning) {
  text(key, wording::words(statement), meaning);
  put_code(key, code_of(statement), code);
}

void Fields::words_or_null(const char* key, const Statement& statement, const char* meaning) {
  text_or_null(key, wording::words(statement), meaning);
  put_code(key, code_of(statement), code);
}

void Fields::words(const char* key, const std::vector<Statement>& statements, const char* meaning) {
  texts(key, wording::words(statements), meaning);
  put_code(key, code_of(statements), R"({"$ref": "#/$defs/codes"})");
}

void Fields::words_for(const char* key, const char* table, const std::string& name,
                       const char* meaning) {
  text(key, purpose_ == Purpose::file ? wording::words_for(table, name) : "", meaning);
}

void Fields::interval(const char* key, const statistics::Estimate& estimate, const char* meaning) {
  put(key, calibration::interval(estimate), R"({"$ref": "#/$defs/estimate_or_null"})", meaning);
}

void Fields::interval(const char* key, const std::optional<statistics::Estimate>& estimate,
                      const char* meaning) {
  put(key, calibration::interval(estimate), R"({"$ref": "#/$defs/estimate_or_null"})", meaning);
}

void Fields::both_sides(const char* key, const std::optional<statistics::Estimate>& motor,
                        double motor_to_joint, const char* meaning) {
  put(key,
      motor ? calibration::both_sides(*motor, motor_to_joint)
            : Json::object({{"motor", nullptr}, {"joint", nullptr}}),
      R"({"$ref": "#/$defs/both_sides"})", meaning);
}

void Fields::put_lists(const char* key, Json lists, const std::vector<std::string>& names,
                       const char* meaning, const char* meaning_of_one) {
  if (purpose_ == Purpose::file) return put(key, std::move(lists), "", meaning);
  Json one = Json::parse(list_of_numbers);
  if (*meaning_of_one != '\0') one["description"] = meaning_of_one;
  put_schema(key,
             {{"type", "object"},
              {"propertyNames", {{"enum", names}}},
              {"additionalProperties", std::move(one)}},
             meaning);
}

void Fields::put(const char* key, Json value, std::string_view schema, const char* meaning) {
  if (purpose_ == Purpose::file) {
    members_[key] = std::move(value);
  } else {
    put_schema(key, Json::parse(schema), meaning);
  }
}

Json Fields::take(const char* meaning) && {
  if (purpose_ == Purpose::file) return std::move(members_);
  Json schema{{"type", "object"}};
  if (*meaning != '\0') schema["description"] = meaning;
  schema["properties"] = std::move(members_);
  schema["required"] = std::move(required_);
  schema["additionalProperties"] = false;
  return schema;
}

void Fields::choose(const char* key, Json value, const std::vector<std::string>& texts,
                    bool or_null, const char* meaning) {
  if (purpose_ == Purpose::file) return put(key, std::move(value), "", meaning);
  Json all = texts;
  if (or_null) all.push_back(nullptr);
  put_schema(key, {{"enum", std::move(all)}}, meaning);
}

void Fields::put(const char* key, Fields&& inner, const char* meaning, bool may_be_null) {
  Json taken = std::move(inner).take();
  if (purpose_ == Purpose::file) return put(key, std::move(taken), "", meaning);
  put_schema(key, may_be_null ? or_null(std::move(taken)) : std::move(taken), meaning);
}

void Fields::put_list(const char* key, std::vector<Fields>&& all, Fields&& of_one,
                      const char* meaning, const char* meaning_of_one) {
  if (purpose_ == Purpose::schema) {
    return put_schema(key, {{"type", "array"}, {"items", std::move(of_one).take(meaning_of_one)}},
                      meaning);
  }
  Json list = Json::array();
  for (Fields& one : all) list.push_back(std::move(one).take());
  put(key, std::move(list), "", meaning);
}

void Fields::put_code(const char* key, Json value, const char* schema) {
  newer().put((std::string(key) + "_code").c_str(), std::move(value), schema);
}

void Fields::put_schema(const char* key, Json schema, const char* meaning) {
  if (*meaning != '\0') schema["description"] = meaning;
  members_[key] = std::move(schema);
  if (!std::exchange(is_newer_, false)) required_.push_back(key);
}

Json common_definitions() {
  return Json::parse(R"({
  "code": {
    "description": "What a machine reads beside the words: \"topic.code\", alone or with its values.",
    "oneOf": [
      {"type": "null"},
      {"type": "string"},
      {
        "type": "object",
        "properties": {
          "code": {"type": "string"},
          "values": {
            "type": "object",
            "description": "By name: a number in the unit in which the words show it, a count, a name, or the codes of what is said inside.",
            "additionalProperties": {
              "oneOf": [{"type": ["number", "string", "null"]}, {"$ref": "#/$defs/codes"}]
            }
          }
        },
        "required": ["code", "values"],
        "additionalProperties": false
      }
    ]
  },
  "codes": {"type": "array", "items": {"$ref": "#/$defs/code"}},
  "estimate": {
    "type": "object",
    "description": "A value with its 95 % interval: low <= estimate <= high.",
    "properties": {
      "estimate": {"type": "number"},
      "low": {"type": ["number", "null"]},
      "high": {"type": ["number", "null"]},
      "method": {"type": "string", "description": "How the interval was made."},
      "method_code": {"$ref": "#/$defs/code"}
    },
    "required": ["estimate", "low", "high", "method"],
    "additionalProperties": false
  },
  "estimate_or_null": {"oneOf": [{"type": "null"}, {"$ref": "#/$defs/estimate"}]},
  "both_sides": {
    "type": "object",
    "description": "The same quantity on both sides of the gear.",
    "properties": {
      "motor": {"$ref": "#/$defs/estimate_or_null"},
      "joint": {"$ref": "#/$defs/estimate_or_null"}
    },
    "required": ["motor", "joint"],
    "additionalProperties": false
  }
})");
}

}  // namespace tribolog::calibration
