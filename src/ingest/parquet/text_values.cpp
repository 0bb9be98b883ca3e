#include "ingest/parquet/text_values.h"

#include <limits>

#include "ingest/text/fields.h"

namespace tribolog::ingest::parquet {
namespace {

constexpr double no_text = std::numeric_limits<double>::quiet_NaN();
/// A column of longer ones holds documents, and no words.
constexpr std::size_t longest_word = 4096;

}  // namespace

double TextValues::number_of(std::string_view text) {
  if (text.empty() || !left_out_.empty()) return no_text;
  if (kind_ == Kind::words) return place_of(text);
  const auto time = text::read_iso_time(text);
  if (kind_ == Kind::unknown) {
    kind_ = time ? Kind::times : Kind::words;
    if (!time) return place_of(text);
    origin_ = time->whole;
  }
  if (!time) {
    left_out_ = "it holds times and other texts";
    return no_text;
  }
  return time->since({origin_, 0.0});
}

double TextValues::place_of(std::string_view text) {
  if (text.size() > longest_word) {
    left_out_ = "it holds long texts";
    return no_text;
  }
  const auto [place, is_new] = places_.emplace(text, words_.size());
  if (is_new) words_.emplace_back(text);
  if (words_.size() > most_words) {
    left_out_ = "it holds more than 4096 different texts";
    return no_text;
  }
  return static_cast<double>(place->second);
}

}  // namespace tribolog::ingest::parquet
