#include "ingest/parquet/table_columns.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace tribolog::ingest::parquet {
namespace {

constexpr double gap = std::numeric_limits<double>::quiet_NaN();
constexpr double day_s = 86'400;
/// From this size on, not every integer has a double of its own.
constexpr std::int64_t first_rounded = std::int64_t{1} << 53;

/// Every `stride`-th number from one on.
template <class Number>
class Strided {
 public:
  Strided(const std::vector<Number>& all, std::size_t first, std::size_t stride)
      : all_(all), first_(first), stride_(stride) {}
  [[nodiscard]] std::size_t size() const { return all_.size() / stride_; }
  [[nodiscard]] Number operator[](std::size_t row) const { return all_[first_ + row * stride_]; }

 private:
  const std::vector<Number>& all_;
  std::size_t first_;
  std::size_t stride_;
};

using Integers = Strided<std::int64_t>;

/// What a number is divided by, which keeps more digits than a factor would.
double divisor_of(const LeafColumn& leaf) {
  if (leaf.logical == LogicalType::decimal) return std::pow(10.0, leaf.scale);
  if (leaf.logical == LogicalType::time) return leaf.units_per_s;
  if (leaf.logical == LogicalType::date) return 1 / day_s;
  return 1;
}

log::ColumnReading reading_of(const LeafColumn& leaf, const TextValues& texts) {
  switch (leaf.logical) {
    case LogicalType::text:
      return texts.are_times() ? log::ColumnReading::iso_time : log::ColumnReading::words;
    case LogicalType::timestamp:
      return log::ColumnReading::iso_time;
    case LogicalType::date:
      return log::ColumnReading::date;
    case LogicalType::time:
      return log::ColumnReading::time_of_day;
    default:
      return leaf.type == PhysicalType::int96 ? log::ColumnReading::iso_time
                                              : log::ColumnReading::number;
  }
}

/// @return the first that is there, else 0.
std::int64_t first_of(const Integers& integers) {
  for (std::size_t row = 0; row < integers.size(); ++row) {
    if (integers[row] != integer_gap) return integers[row];
  }
  return 0;
}

bool reaches(const Integers& integers, std::int64_t bound) {
  for (std::size_t row = 0; row < integers.size(); ++row) {
    const std::int64_t value = integers[row];
    if (value != integer_gap && (value >= bound || value <= -bound)) return true;
  }
  return false;
}

/// A whole number of `step`, not above it; beside the lowest integer the one above.
std::int64_t rounded_down(std::int64_t value, std::int64_t step) {
  const std::int64_t towards_zero = value - value % step;
  const bool is_above = value % step < 0;
  const bool has_next = towards_zero >= std::numeric_limits<std::int64_t>::min() + step;
  return is_above && has_next ? towards_zero - step : towards_zero;
}

/// Takes the integers less an origin, over a divisor.
void take_since(const Integers& integers, std::int64_t origin, double divisor, TableColumns& to,
                std::vector<double>& values) {
  for (std::size_t row = 0; row < integers.size(); ++row) {
    std::int64_t since = 0;
    if (integers[row] == integer_gap) {
      values[row] = gap;
    } else if (__builtin_sub_overflow(integers[row], origin, &since)) {
      to.was_rounded = true;
      values[row] = (static_cast<double>(integers[row]) - static_cast<double>(origin)) / divisor;
    } else {
      to.was_rounded = to.was_rounded || since >= first_rounded || since <= -first_rounded;
      values[row] = static_cast<double>(since) / divisor;
    }
  }
}

void take_unsigned(const Integers& integers, TableColumns& to, std::vector<double>& values) {
  to.was_rounded = true;
  for (std::size_t row = 0; row < integers.size(); ++row) {
    values[row] = integers[row] == integer_gap
                      ? gap
                      : static_cast<double>(static_cast<std::uint64_t>(integers[row]));
  }
}

/// Doubles hold these to the last bit once the origin is taken off; and the origin itself.
void take_integers(const LeafColumn& leaf, const Integers& integers, TableColumns& to,
                   log::LogColumn& column) {
  column.values.resize(integers.size());
  const bool is_int96 = leaf.type == PhysicalType::int96;
  if (leaf.logical == LogicalType::timestamp || is_int96) {
    constexpr std::int64_t nanoseconds = 1'000'000'000;
    const auto units = is_int96 ? nanoseconds : static_cast<std::int64_t>(leaf.units_per_s);
    const std::int64_t origin = rounded_down(first_of(integers), units);
    column.origin = static_cast<double>(origin / units);
    return take_since(integers, origin, static_cast<double>(units), to, column.values);
  }
  const bool is_unsigned = leaf.logical == LogicalType::unsigned_integer;
  bool has_top_bit = false;
  for (std::size_t row = 0; is_unsigned && row < integers.size(); ++row) {
    has_top_bit = has_top_bit || (integers[row] < 0 && integers[row] != integer_gap);
  }
  if (has_top_bit) return take_unsigned(integers, to, column.values);
  const double divisor = divisor_of(leaf);
  std::int64_t origin = 0;
  if (divisor == 1 && reaches(integers, first_rounded)) {
    constexpr std::int64_t bits_beyond_double = std::int64_t{1} << 11;
    origin = rounded_down(first_of(integers), bits_beyond_double);
  }
  column.origin = static_cast<double>(origin);
  take_since(integers, origin, divisor, to, column.values);
}

void take_reals(const LeafColumn& leaf, const Strided<double>& reals, log::LogColumn& column) {
  column.values.resize(reals.size());
  const double divisor = divisor_of(leaf);
  for (std::size_t row = 0; row < reals.size(); ++row) {
    column.values[row] = divisor == 1 ? reals[row] : reals[row] / divisor;
  }
}

/// What is infinite is a gap.
void count_gaps(log::LogColumn& column) {
  for (double& value : column.values) {
    if (std::isfinite(value)) continue;
    value = gap;
    ++column.gaps;
  }
}

}  // namespace

TableColumns table_columns(const LeafColumn& leaf, ColumnValues& values) {
  TableColumns result;
  const std::size_t elements = values.elements();
  for (std::size_t k = 0; k < elements; ++k) {
    log::LogColumn column;
    column.reading = reading_of(leaf, values.texts());
    if (column.reading == log::ColumnReading::words) column.words = values.texts().words();
    if (leaf.storage == Storage::integer) {
      take_integers(leaf, {values.numbers().integers, k, elements}, result, column);
    } else {
      if (leaf.logical == LogicalType::text) column.origin = values.texts().origin();
      const bool as_they_are = elements == 1 && divisor_of(leaf) == 1;
      if (as_they_are) {
        column.values = values.take_reals();
      } else {
        take_reals(leaf, {values.numbers().reals, k, elements}, column);
      }
    }
    count_gaps(column);
    result.columns.push_back(std::move(column));
  }
  return result;
}

}  // namespace tribolog::ingest::parquet
