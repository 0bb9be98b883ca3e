#pragma once
// One axis of a panel: what it shows and where, and the round numbers and calendar dates on it.

#include <string>
#include <vector>

#include "base/statement.h"
#include "render/figure/figure.h"

namespace tribolog::render::layout {

/// `low < high`, both finite; on a logarithmic axis both positive.
struct AxisRange {
  double low{};
  double high{};
  friend bool operator==(const AxisRange&, const AxisRange&) = default;
};

/// What can be drawn at all: finite, of a magnitude that leaves room for arithmetic and, on a
/// logarithmic axis, positive.
bool drawable(double value, bool logarithmic);

class AxisMap {
 public:
  AxisMap() = default;
  /// `pixel_low` and `pixel_high` are where the ends of the range lie.
  AxisMap(AxisRange range, const figure::Axis& axis, double pixel_low, double pixel_high);

  [[nodiscard]] double pixel(double value) const;
  [[nodiscard]] const AxisRange& range() const { return range_; }
  [[nodiscard]] bool logarithmic() const { return logarithmic_; }

 private:
  AxisRange range_{0.0, 1.0};
  bool logarithmic_{false};
  double linear_within_{0.0};
  double origin_{0.0};  ///< Data along the axis, at `pixel_low_`.
  double pixel_low_{0.0};
  double scale_{1.0};
};

// Which stretch of an axis a panel shows.

/// Smallest and largest drawable value seen; `empty()` until the first.
class DataExtent {
 public:
  explicit DataExtent(bool logarithmic) : logarithmic_(logarithmic) {}
  void add(double value);
  void add(const DataExtent& other);
  [[nodiscard]] bool empty() const { return !(low_ <= high_); }
  [[nodiscard]] double low() const { return low_; }
  [[nodiscard]] double high() const { return high_; }

 private:
  bool logarithmic_;
  double low_{1e308};
  double high_{-1e308};
};

/// Extent of everything in a panel that has a place on the axis: series, bands, error bars, point
/// labels and reference lines.
DataExtent x_extent(const figure::Panel& panel);
DataExtent y_extent(const figure::Panel& panel);

/// The range with a margin around the data, or the fixed ends of the axis. A constant or a missing
/// extent gives a range that is fit to draw; impossible fixed ends are ignored with a warning.
AxisRange choose_range(const DataExtent& extent, const figure::Axis& axis, double margin_share,
                       std::vector<Statement>& warnings);

// Ticks, and how to write them.

/// Exact text of multiple * 10^exponent: decimal_text(-25, -1) is "−2.5".
std::string decimal_text(long long multiple, int exponent);

std::string integer_text(int value);

/// A positive number in as few digits as identify it, as markup: "1.7·10^{9}", "1700000123".
std::string magnitude_text(double value);

/// "0.01", "50", "10^{5}", "2·10^{−4}".
std::string logarithmic_text(int digit, int exponent);

/// digit * 10^exponent, correctly rounded.
double power_of_ten_multiple(int digit, int exponent);

/// The power of ten to take out of all labels so that they stay short; 0 for everyday numbers.
struct CommonPower {
  int exponent{};
};
CommonPower common_power(const std::vector<long long>& multiples, int exponent);

struct Tick {
  double value{};
  std::string label;  ///< Figure markup.
};

/// Labels are distinct. `scale_note` (markup, often empty) says what to do with every label:
/// "×10^{6}" to multiply, "+ 1.7·10^{9}" to add, or both in this order.
struct TickSet {
  std::vector<Tick> major;
  std::vector<double> minor;  ///< Logarithmic axes only.
  std::string scale_note;
};

/// Multiples of 1, 2 or 5 times a power of ten, at most `most` of them (at least 2 where the range
/// allows it), no closer than `least_step`. @pre range as AxisRange demands; most >= 2.
TickSet linear_ticks(const AxisRange& range, int most, double least_step = 0.0);

/// Decades; where the range is short also their 2- and 5-fold, or linear ticks.
TickSet logarithmic_ticks(const AxisRange& range, int most);

/// Zero, and decades in both directions from `linear_within` on.
TickSet symmetric_ticks(const AxisRange& range, double linear_within, int most);

/// Whole years ("2026"), months ("2026-03"), days ("2026-03-05") or hours ("2026-03-05 06:00"), at
/// most `most` of them, and at least one where the range holds a whole hour. UTC.
/// @param range days since 1970-01-01; outside of the years 1 to 9999, or shorter than two hours,
///        the ticks are those of plain numbers.
TickSet date_ticks(const AxisRange& range, int most);

}  // namespace tribolog::render::layout
