#pragma once
// One axis of a panel: what it shows, and where.

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
  AxisMap(AxisRange range, bool logarithmic, double pixel_low, double pixel_high);

  [[nodiscard]] double pixel(double value) const;
  [[nodiscard]] const AxisRange& range() const { return range_; }
  [[nodiscard]] bool logarithmic() const { return logarithmic_; }

 private:
  AxisRange range_{0.0, 1.0};
  bool logarithmic_{false};
  double origin_{0.0};  ///< Data, or its decimal logarithm, at `pixel_low_`.
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

}  // namespace tribolog::render::layout
