#pragma once
// What the method has to say, without words: a code, and the values that belong to it.
//
// The rooms that compute state what they found; wording/ alone makes sentences of it, in the
// language of the page. JSON has the code beside the words, so that a machine can read it.

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace tribolog {

/// What is stated: "gravity.one_direction", the topic and what is said on it. Compares as text,
/// copies as a pointer.
class Code {
 public:
  Code() = default;
  template <std::size_t size>
  consteval Code(const char (&literal)[size]) : text_(literal, size - 1) {}  // NOLINT
  /// Of a text from a file, or put together: it is kept as long as the program runs.
  static Code of(const std::string& text);
  [[nodiscard]] std::string_view text() const { return text_; }
  [[nodiscard]] bool empty() const { return text_.empty(); }
  friend bool operator==(const Code& a, const Code& b) { return a.text_ == b.text_; }

 private:
  explicit Code(std::string_view kept) : text_(kept) {}
  std::string_view text_;
};

struct StatedValue;

/// A code with its values; empty where there is nothing to say.
class Statement {
 public:
  Statement() = default;
  Statement(Code code);  // NOLINT: a code alone is a statement.
  Statement(Code code, std::initializer_list<StatedValue> values);
  static Statement with(Code code, std::vector<StatedValue> values);
  /// Words that have no code: of a person, or of a file that an older program wrote.
  static Statement verbatim(const std::string& words);

  /// Says one thing more: "a; b". What is empty adds nothing.
  void add(const Statement& more);

  [[nodiscard]] bool empty() const { return code_.empty(); }
  [[nodiscard]] Code code() const { return code_; }
  [[nodiscard]] bool is(Code code) const { return code_ == code; }
  [[nodiscard]] const std::vector<StatedValue>& values() const { return values_; }
  friend bool operator==(const Statement& a, const Statement& b);

 private:
  Code code_;
  std::vector<StatedValue> values_;
};

/// One value of a statement, by its name in the message.
struct StatedValue {
  /// A number in the unit in which it is shown; a count; a name that is the same in every language
  /// (of a file, a column, a unit, an estimator); statements inside this one.
  using Value = std::variant<double, std::int64_t, std::string, std::vector<Statement>>;

  StatedValue(std::string_view n, std::floating_point auto v)
      : name(n), value(static_cast<double>(v)) {}
  StatedValue(std::string_view n, std::integral auto v)
      : name(n), value(static_cast<std::int64_t>(v)) {}
  StatedValue(std::string_view n, std::string v) : name(n), value(std::move(v)) {}
  StatedValue(std::string_view n, const char* v) : name(n), value(std::string(v)) {}
  StatedValue(std::string_view n, Statement v) : name(n), value(std::vector{std::move(v)}) {}
  StatedValue(std::string_view n, std::vector<Statement> v) : name(n), value(std::move(v)) {}
  friend bool operator==(const StatedValue&, const StatedValue&) = default;

  std::string name;
  Value value;
};

/// The code with its values, for whoever has no words: "gravity.no_overlap (share 0.3)".
std::string as_code(const Statement& statement);

/// The same with each text among the values, and in statements inside, as `shown` makes it.
Statement with_texts(const Statement& statement, std::string (*shown)(const std::string& text));

/// Something stated cannot be used: a parameter out of its bounds, a motion that cannot be driven.
/// what() is the code with its values; wording::words() has the sentence.
class Refusal : public std::invalid_argument {
 public:
  explicit Refusal(Statement statement);
  [[nodiscard]] const Statement& statement() const { return statement_; }

 private:
  Statement statement_;
};

}  // namespace tribolog
