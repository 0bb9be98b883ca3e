#pragma once
// Units of an axis: the SI prefix that keeps tick labels short, and the axis title with it.

#include <string>
#include <vector>

namespace tribolog::wording {

/// Smallest and largest of some numbers; those that are not finite do not count.
struct Extent {
  double low{};
  double high{};
  bool empty{true};

  void add(double value);
  void add(const std::vector<double>& values);
  [[nodiscard]] double span() const { return empty ? 0.0 : high - low; }
  [[nodiscard]] double largest() const;  ///< Largest absolute value; 0 if empty.
};

Extent extent_of(const std::vector<double>& values);

/// Shown number = (SI number - offset) * factor.
struct AxisScale {
  double factor{1.0};
  std::string unit;  ///< "µrad"
  double offset{0.0};

  [[nodiscard]] double operator()(double si) const { return (si - offset) * factor; }
};

/// The prefix (none, m, µ, n) with which `largest` is shown as 0.5 to 500 if it is below 0.5 of the
/// unit; larger values keep the unit. Zero or not finite: the unit itself.
AxisScale prefixed(const std::string& si_unit, double largest);

/// Radians shown in degrees.
AxisScale degrees();

/// An axis for values that may vary by a small part of their level only: then a round offset is
/// taken off, so that ticks read 0.2, 0.4 and not 4.76612, 4.76614.
AxisScale levelled(const std::string& si_unit, const Extent& extent);

/// "driving torque T [N·m]"; with an offset "driving torque T − 4.766 N·m [mN·m]".
/// @param si_unit the unit of the offset.
std::string axis_title(const std::string& quantity_and_symbol, const AxisScale& scale,
                       const std::string& si_unit = "");

}  // namespace tribolog::wording
