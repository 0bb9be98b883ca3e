#include "paper/charts/static_law_panel.h"

#include <utility>

#include <fmt/format.h>

#include "figures/plot_data.h"

namespace tribolog::paper {
namespace {

using figures::AxisScale;
using figures::prefixed;

constexpr double curve_px = 4.0;
constexpr double part_px = 3.0;

void add_line(render::Panel& panel, render::ReferenceLine::Direction direction, double at,
              const std::string& text) {
  panel.reference_lines.push_back({direction, at, text});
}

}  // namespace

std::string parameter_text(double value, const std::string& si_unit) {
  const AxisScale scale = si_unit == "N·m" ? AxisScale{1.0, si_unit} : prefixed(si_unit, value);
  return fmt::format("{:.4g} {}", scale(value), scale.unit);
}

render::Panel static_law_panel(double largest_rad_s, double largest_Nm) {
  const AxisScale speeds = prefixed("rad/s", largest_rad_s);
  constexpr double margin = 1.25;  // room for the legend
  render::Panel panel;
  panel.x.title = figures::axis_title("motor speed ω", speeds);
  panel.x.minimum = speeds(-largest_rad_s);
  panel.x.maximum = speeds(largest_rad_s);
  panel.y.title = "friction T_{f} [N·m]";
  panel.y.minimum = -margin * largest_Nm;
  panel.y.maximum = margin * largest_Nm;
  return panel;
}

render::Series law_series(const StaticLaw& law, double from_rad_s, double to_rad_s,
                          const AxisScale& speeds) {
  constexpr int pieces = 600;
  std::vector<double> x;
  std::vector<double> y;
  for (int i = 0; i <= pieces; ++i) {
    const double share = static_cast<double>(i) / pieces;
    const double speed = (1 - share) * from_rad_s + share * to_rad_s;
    x.push_back(speeds(speed));
    y.push_back(law(speed));
  }
  return figures::line("", std::move(x), std::move(y), render::palette::blue, curve_px);
}

void add_levels(render::Panel& panel, const StaticLevels& levels, double largest_rad_s) {
  using Direction = render::ReferenceLine::Direction;
  const AxisScale speeds = prefixed("rad/s", largest_rad_s);
  const std::string fall =
      fmt::format("{} = {}", levels.fall_symbol, parameter_text(levels.fall_rad_s, "rad/s"));
  add_line(panel, Direction::horizontal, levels.static_Nm,
           "T_{brk} = " + parameter_text(levels.static_Nm, "N·m"));
  add_line(panel, Direction::horizontal, levels.coulomb_Nm,
           "T_{c} = " + parameter_text(levels.coulomb_Nm, "N·m"));
  add_line(panel, Direction::horizontal, -levels.coulomb_Nm, "−T_{c}");
  add_line(panel, Direction::horizontal, -levels.static_Nm, "−T_{brk}");
  add_line(panel, Direction::vertical, speeds(levels.fall_rad_s), fall);
  add_line(panel, Direction::vertical, speeds(-levels.fall_rad_s), "−" + levels.fall_symbol);
  const auto viscous = [&](double side, const std::string& label) {
    const double end_Nm = levels.coulomb_Nm + levels.viscous_Nms_rad * largest_rad_s;
    panel.series.push_back(figures::line(
        label, {0.0, side * speeds(largest_rad_s)}, {side * levels.coulomb_Nm, side * end_Nm},
        render::palette::vermilion, part_px, render::LineStyle::dash));
  };
  viscous(-1, "");
  viscous(+1, fmt::format("T_{{c}} + {0} |ω|, slope {0} = {1}", levels.slope_symbol,
                          parameter_text(levels.viscous_Nms_rad, "N·m·s/rad")));
}

std::string levels_words(const StaticLevels& levels) {
  return fmt::format("break-away torque {}, Coulomb torque {}, viscous slope {}",
                     parameter_text(levels.static_Nm, "N·m"),
                     parameter_text(levels.coulomb_Nm, "N·m"),
                     parameter_text(levels.viscous_Nms_rad, "N·m·s/rad"));
}

}  // namespace tribolog::paper
