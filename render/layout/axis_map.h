#pragma once
// From data to pixels along one axis, in double precision.

namespace tribolog::render {

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

}  // namespace tribolog::render
