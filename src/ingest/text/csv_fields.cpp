#include "ingest/text/csv_fields.h"

#include <cstddef>
#include <utility>

#include "base/closest_match.h"
#include "ingest/text/number_field.h"

namespace tribolog {
namespace {

class RowSplitter {
 public:
  RowSplitter(std::string_view row, Delimiter delimiter, const Location& line)
      : row_(row), delimiter_(delimiter), line_(line) {}

  std::vector<Field> split() {
    const bool by_spaces = delimiter_ == Delimiter::spaces;
    for (skip_blanks(); !(by_spaces && at_end()); skip_blanks()) {
      fields_.push_back(next_field());
      if (fields_.size() > most_columns) {
        fail({line_.file, line_.line, 0},
             {"more than " + std::to_string(most_columns) + " columns", "", "", ""});
      }
      skip_blanks();
      if (at_end()) break;
      if (!by_spaces) ++i_;  // the delimiter
      if (!by_spaces && at_end()) {
        fields_.push_back({"", i_ + 1});
        break;
      }
    }
    return std::move(fields_);
  }

 private:
  [[noreturn]] static void fail(const Location& where, const InputError::Problem& problem) {
    throw InputError(where, problem);
  }
  [[nodiscard]] bool at_end() const { return i_ >= row_.size(); }
  [[nodiscard]] bool at_delimiter() const {
    return delimiter_ == Delimiter::spaces ? row_[i_] == ' ' || row_[i_] == '\t'
                                           : row_[i_] == static_cast<char>(delimiter_);
  }
  [[nodiscard]] Location at(std::size_t i) const {
    return {line_.file, line_.line, static_cast<long>(i + 1)};
  }
  void skip_blanks() {
    while (!at_end() && (row_[i_] == ' ' || row_[i_] == '\t') &&
           (delimiter_ == Delimiter::spaces || !at_delimiter())) {
      ++i_;
    }
  }

  Field next_field() {
    const std::size_t start = i_;
    if (!at_end() && row_[i_] == '"') return quoted_field();
    while (!at_end() && !at_delimiter()) ++i_;
    check_length(start, i_ - start);
    return {std::string(trimmed(row_.substr(start, i_ - start))), start + 1};
  }

  Field quoted_field() {
    const std::size_t start = i_++;
    std::string text;
    for (;; ++i_) {
      if (at_end()) {
        fail(at(start), {"quote is not closed in its line", "", "",
                         "a line end within quotes is not supported"});
      }
      if (row_[i_] == '"' && (i_ + 1 >= row_.size() || row_[i_ + 1] != '"')) break;
      if (row_[i_] == '"') ++i_;
      text += row_[i_];
    }
    ++i_;
    check_length(start, text.size());
    skip_blanks_within();
    if (!at_end() && !at_delimiter()) {
      fail(at(i_), {"text after a closing quote", in_quotes(row_.substr(i_, 20)),
                    "a delimiter or the end of the line", ""});
    }
    return {std::string(trimmed(text)), start + 1};
  }
  void skip_blanks_within() {
    if (delimiter_ != Delimiter::spaces) skip_blanks();
  }

  void check_length(std::size_t start, std::size_t bytes) const {
    if (bytes <= longest_field_bytes) return;
    fail(at(start), {"field is longer than 64 KiB", std::to_string(bytes) + " bytes", "", ""});
  }

  std::string_view row_;
  Delimiter delimiter_;
  const Location& line_;
  std::size_t i_{0};
  std::vector<Field> fields_;
};

}  // namespace

std::vector<Field> split_row(std::string_view row, Delimiter delimiter, const Location& line) {
  return RowSplitter(row, delimiter, line).split();
}

}  // namespace tribolog
