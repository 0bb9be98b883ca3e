#pragma once
// The keys of an object of calibration.json, each stated once: its name, what stands there and what
// it means. A function that states them writes the object into the file, or its JSON schema.

#include <concepts>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/enum_text.h"
#include "base/statement.h"
#include "calibration/json_values.h"
#include "statistics/estimate.h"

namespace tribolog::calibration {

class Fields {
 public:
  enum class Purpose { file, schema };
  explicit Fields(Purpose purpose) : purpose_(purpose) {}

  /// Of the next key: files of older programs lack it.
  Fields& newer() {
    is_newer_ = true;
    return *this;
  }

  void flag(const char* key, bool value, const char* meaning = "");
  void flag(const char* key, std::optional<bool> value, const char* meaning = "");
  template <std::integral Count>
  void count(const char* key, Count value, const char* meaning = "") {
    put(key, Json(value), R"({"type": "integer", "minimum": 0})", meaning);
  }
  /// null: not known.
  void number(const char* key, double value, const char* meaning = "");
  void number(const char* key, const std::optional<double>& value, const char* meaning = "");
  /// Always known.
  void known_number(const char* key, double value, const char* meaning = "");
  void numbers(const char* key, const std::vector<double>& values, const char* meaning = "");
  void text(const char* key, const std::string& text, const char* meaning = "");
  /// null: empty.
  void text_or_null(const char* key, const std::string& text, const char* meaning = "");
  void texts(const char* key, const std::vector<std::string>& texts, const char* meaning = "");
  /// Words, and the code of them behind: "reason", "reason_code".
  void words(const char* key, const Statement& statement, const char* meaning = "");
  /// null: empty.
  void words_or_null(const char* key, const Statement& statement, const char* meaning = "");
  void words(const char* key, const std::vector<Statement>& statements, const char* meaning = "");
  /// The words that a table of names has for one of them (wording::words_for).
  void words_for(const char* key, const char* table, const std::string& name,
                 const char* meaning = "");
  void interval(const char* key, const statistics::Estimate& estimate, const char* meaning = "");
  /// null: not identified.
  void interval(const char* key, const std::optional<statistics::Estimate>& estimate,
                const char* meaning = "");
  /// The same quantity on both sides of the gear, each null where it was not identified.
  void both_sides(const char* key, const std::optional<statistics::Estimate>& motor,
                  double motor_to_joint, const char* meaning = "");
  /// A list for each of some enumerators.
  template <typename Enum>
  void numbers_by_name(const char* key, Json lists, const char* meaning = "",
                       const char* meaning_of_one = "") {
    put_lists(key, std::move(lists), texts_of<Enum>(), meaning, meaning_of_one);
  }

  template <typename Enum>
    requires std::is_enum_v<Enum>
  void choice(const char* key, Enum value, const char* meaning = "") {
    choose(key, Json(std::string(to_string(value))), texts_of<Enum>(), false, meaning);
  }
  template <typename Enum>
    requires std::is_enum_v<Enum>
  void choice(const char* key, const std::optional<Enum>& value, const char* meaning = "") {
    choose(key, value ? Json(std::string(to_string(*value))) : Json(nullptr), texts_of<Enum>(),
           true, meaning);
  }
  /// @param describe states the keys: describe(Fields&)
  template <typename Describe>
  void object(const char* key, const char* meaning, const Describe& describe) {
    Fields inner(purpose_);
    describe(inner);
    put(key, std::move(inner), meaning, false);
  }
  /// @param describe states the keys of what is there: describe(Fields&, const T&)
  /// @param sample of which nothing but the kinds of its members is looked at
  template <typename T, typename Describe>
  void object_or_null(const char* key, const T* value, const char* meaning,
                      const Describe& describe, const T& sample = T()) {
    if (value == nullptr && purpose_ == Purpose::file) return put(key, Json(nullptr), "", "");
    Fields inner(purpose_);
    describe(inner, value == nullptr ? sample : *value);
    put(key, std::move(inner), meaning, true);
  }
  template <typename T, typename Describe>
  void object_or_null(const char* key, const std::optional<T>& value, const char* meaning,
                      const Describe& describe, const T& sample = T()) {
    object_or_null(key, value ? &*value : nullptr, meaning, describe, sample);
  }
  /// @param describe states the keys of one: describe(Fields&, const T&)
  template <typename T, typename Describe>
  void list(const char* key, const std::vector<T>& all, const char* meaning,
            const Describe& describe, const char* meaning_of_one = "", const T& sample = T()) {
    std::vector<Fields> described;
    for (const T& one : all) describe(described.emplace_back(purpose_), one);
    Fields of_one(Purpose::schema);
    if (purpose_ == Purpose::schema) describe(of_one, sample);
    put_list(key, std::move(described), std::move(of_one), meaning, meaning_of_one);
  }
  /// Anything else. @param schema JSON.
  void put(const char* key, Json value, std::string_view schema, const char* meaning = "");

  /// What was stated: the object, or the schema of such objects.
  [[nodiscard]] Json take(const char* meaning = "") &&;

 private:
  template <typename Enum>
  [[nodiscard]] std::vector<std::string> texts_of() const {
    std::vector<std::string> texts;
    if (purpose_ == Purpose::file) return texts;
    for (std::size_t i = 0; i < EnumTexts<Enum>::size; ++i) {
      texts.emplace_back(to_string(static_cast<Enum>(i)));
    }
    std::erase(texts, "");  // of an enumerator that stands for none
    return texts;
  }
  void choose(const char* key, Json value, const std::vector<std::string>& texts, bool or_null,
              const char* meaning);
  void put(const char* key, Fields&& inner, const char* meaning, bool or_null);
  void put_list(const char* key, std::vector<Fields>&& all, Fields&& of_one, const char* meaning,
                const char* meaning_of_one);
  void put_lists(const char* key, Json lists, const std::vector<std::string>& names,
                 const char* meaning, const char* meaning_of_one);
  void put_code(const char* key, Json code, const char* schema);
  void put_schema(const char* key, Json schema, const char* meaning);

  Purpose purpose_;
  bool is_newer_{false};
  Json members_ = Json::object();  ///< Of the file's object, or their schemas.
  Json required_ = Json::array();
};

/// What several keys have in common, as the schema's "$defs".
Json common_definitions();

}  // namespace tribolog::calibration
