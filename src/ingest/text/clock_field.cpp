#include <charconv>
#include <chrono>

#include "ingest/text/fields.h"

namespace tribolog::ingest::text {
namespace {

std::size_t digits_at_start(std::string_view text) {
  std::size_t n = 0;
  while (n < text.size() && is_digit(text[n])) ++n;
  return n;
}

std::int64_t whole_number(std::string_view digits) {
  std::int64_t value = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return value;
}

/// 0.digits
double fraction(std::string_view digits) {
  constexpr std::size_t most_digits = 18;
  digits = digits.substr(0, most_digits);
  double scale = 1;
  for (std::size_t i = 0; i < digits.size(); ++i) scale *= 10;
  return static_cast<double>(whole_number(digits)) / scale;
}

/// Walks a text of numbers of fixed width.
class Fields {
 public:
  explicit Fields(std::string_view text) : rest_(text) {}

  [[nodiscard]] bool is_good() const { return good_; }
  [[nodiscard]] bool at_end() const { return rest_.empty(); }
  [[nodiscard]] char next() const { return rest_.empty() ? '\0' : rest_.front(); }

  int number(std::size_t width) {
    if (digits_at_start(rest_) < width) {
      good_ = false;
      return 0;
    }
    const auto value = static_cast<int>(whole_number(rest_.substr(0, width)));
    rest_.remove_prefix(width);
    return value;
  }
  bool take(std::string_view any_of) {
    if (rest_.empty() || any_of.find(rest_.front()) == std::string_view::npos) return false;
    rest_.remove_prefix(1);
    return true;
  }
  void need(std::string_view any_of) { good_ = take(any_of) && good_; }
  void hold_to(bool rule) { good_ = rule && good_; }
  double digits_behind_the_mark() {
    const std::size_t n = digits_at_start(rest_);
    if (n == 0) good_ = false;
    const double value = fraction(rest_.substr(0, n));
    rest_.remove_prefix(n);
    return value;
  }

 private:
  std::string_view rest_;
  bool good_{true};
};

/// Seconds that the offset is ahead of UTC; 0 for "Z" and for none. No place on Earth is further
/// ahead than 14 hours.
std::int64_t offset_s(Fields& fields) {
  constexpr int most_hours = 14;
  if (fields.at_end() || fields.take("Zz")) return 0;
  const std::int64_t sign = fields.next() == '-' ? -1 : 1;
  fields.need("+-");
  const int hours = fields.number(2);
  fields.hold_to(hours <= most_hours);
  if (fields.at_end()) return sign * hours * 3600;
  fields.take(":");
  const int minutes = fields.number(2);
  fields.hold_to(minutes < 60);
  return sign * (hours * 3600 + minutes * 60);
}

/// In seconds since midnight; a second may be a leap second.
ClockReading time_of_day(Fields& fields, std::size_t hour_digits) {
  constexpr int leap_second = 60;
  const int hour = fields.number(hour_digits);
  fields.need(":");
  const int minute = fields.number(2);
  fields.need(":");
  const int second = fields.number(2);
  const double rest = fields.take(".,") ? fields.digits_behind_the_mark() : 0.0;
  fields.hold_to(hour <= 23 && minute <= 59 && second <= leap_second);
  return {(std::int64_t{hour} * 60 + minute) * 60 + second, rest};
}

/// From 1970 to the midnight with which a day begins.
std::optional<std::int64_t> seconds_to(int year, int month, int day) {
  const std::chrono::year_month_day date{std::chrono::year(year),
                                         std::chrono::month(static_cast<unsigned>(month)),
                                         std::chrono::day(static_cast<unsigned>(day))};
  if (!date.ok()) return std::nullopt;
  constexpr std::int64_t seconds_a_day = 86'400;
  return std::chrono::sys_days(date).time_since_epoch().count() * seconds_a_day;
}

}  // namespace

std::optional<ClockReading> read_clock_number(std::string_view field, DecimalMark mark) {
  std::string_view text = trimmed(field);
  const bool is_negative = text.starts_with('-');
  if (is_negative || text.starts_with('+')) text.remove_prefix(1);
  const std::size_t n = digits_at_start(text);
  ClockReading reading;
  const auto read = std::from_chars(text.data(), text.data() + n, reading.whole);
  if (n == 0 || read.ec != std::errc()) return std::nullopt;
  text.remove_prefix(n);
  if (!text.empty()) {
    if (text.front() != (mark == DecimalMark::comma ? ',' : '.')) return std::nullopt;
    text.remove_prefix(1);
    if (digits_at_start(text) != text.size()) return std::nullopt;
    reading.rest = fraction(text);
  }
  if (!is_negative) return reading;
  reading.whole = -reading.whole;
  if (reading.rest > 0) reading = {reading.whole - 1, 1 - reading.rest};
  return reading;
}

std::optional<ClockReading> read_iso_time(std::string_view field) {
  Fields fields(trimmed(field));
  const int year = fields.number(4);
  fields.need("-");
  const int month = fields.number(2);
  fields.need("-");
  const int day = fields.number(2);
  fields.need("T t");
  const ClockReading of_day = time_of_day(fields, 2);
  const std::int64_t ahead_s = offset_s(fields);
  const std::optional<std::int64_t> midnight_s = seconds_to(year, month, day);
  if (!fields.is_good() || !fields.at_end() || !midnight_s) return std::nullopt;
  return ClockReading{*midnight_s + of_day.whole - ahead_s, of_day.rest};
}

std::optional<ClockReading> read_time_of_day(std::string_view field) {
  const std::string_view text = trimmed(field);
  Fields fields(text);
  const ClockReading of_day = time_of_day(fields, text.find(':') == 1 ? 1 : 2);
  if (!fields.is_good() || !fields.at_end()) return std::nullopt;
  return of_day;
}

std::optional<ClockReading> read_date(std::string_view field) {
  const std::string_view text = trimmed(field);
  Fields fields(text);
  constexpr std::size_t year_digits = 4;
  const bool is_year_first = digits_at_start(text) == year_digits;
  const bool has_slashes = text.find('/') == year_digits;
  const std::string_view sign = !is_year_first ? "." : has_slashes ? "/" : "-";
  const int first = fields.number(is_year_first ? year_digits : 2);
  fields.need(sign);
  const int month = fields.number(2);
  fields.need(sign);
  const int last = fields.number(is_year_first ? 2 : year_digits);
  const auto midnight_s =
      is_year_first ? seconds_to(first, month, last) : seconds_to(last, month, first);
  if (!fields.is_good() || !fields.at_end() || !midnight_s) return std::nullopt;
  return ClockReading{*midnight_s, 0.0};
}

std::optional<ClockReading> read_time(std::string_view field, log::ColumnReading reading,
                                      DecimalMark mark) {
  switch (reading) {
    case log::ColumnReading::clock:
      return read_clock_number(field, mark);
    case log::ColumnReading::iso_time:
      return read_iso_time(field);
    case log::ColumnReading::time_of_day:
      return read_time_of_day(field);
    case log::ColumnReading::date:
      return read_date(field);
    case log::ColumnReading::number:
    case log::ColumnReading::words:
      break;
  }
  return std::nullopt;
}

}  // namespace tribolog::ingest::text
