#pragma once
// Texts of a column: times in ISO 8601, or words.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace tribolog::ingest::parquet {

/// Different words of one column; where there are more of them, they are no words.
inline constexpr std::size_t most_words = 4096;

/// The first text shows which it is; a column that then has others is not read.
class TextValues {
 public:
  /// @return the word's place in words(), or seconds since origin(); NaN of an empty text, and
  /// where the column is not read.
  double number_of(std::string_view text);

  [[nodiscard]] bool are_times() const { return kind_ == Kind::times; }
  [[nodiscard]] double origin() const { return static_cast<double>(origin_); }
  [[nodiscard]] const std::vector<std::string>& words() const { return words_; }
  /// Why the column is not read; empty: it is.
  [[nodiscard]] const std::string& left_out() const { return left_out_; }

 private:
  enum class Kind : std::uint8_t { unknown, times, words };

  double place_of(std::string_view text);

  Kind kind_{Kind::unknown};
  std::int64_t origin_{};
  std::vector<std::string> words_;
  std::unordered_map<std::string, std::size_t> places_;
  std::string left_out_;
};

}  // namespace tribolog::ingest::parquet
