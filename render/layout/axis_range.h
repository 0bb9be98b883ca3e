#pragma once
// Which stretch of an axis a panel shows.

#include <string>
#include <vector>

#include "render/figure/figure.h"
#include "render/layout/axis_map.h"

namespace tribolog::render {

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
DataExtent x_extent(const Panel& panel);
DataExtent y_extent(const Panel& panel);

/// The range with a margin around the data, or the fixed ends of the axis. A constant or a missing
/// extent gives a range that is fit to draw; impossible fixed ends are ignored with a warning.
AxisRange choose_range(const DataExtent& extent, const Axis& axis, double margin_share,
                       std::vector<std::string>& warnings);

}  // namespace tribolog::render
