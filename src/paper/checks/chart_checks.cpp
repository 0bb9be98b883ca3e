// Figures 1, 2 and 5: charts of friction laws, checked on the points that are drawn.

#include <algorithm>
#include <limits>

#include "base/requirements.h"
#include "paper/checks/check.h"
#include "paper/drawings/paper_drawings.h"
#include "paper/drawings/printed_paper.h"
#include "statistics/random_stream.h"
#include "wording/axis_scale.h"
#include "wording/tr.h"

namespace tribolog::paper::checks {

namespace {

using wording::tr;
using wording::tr_count;

constexpr double chart_rounding_Nm = 1e-12;

/// Largest distance of a drawn law's points from the law: it is what is drawn solid.
template <class Law>
double off_the_law(const render::figure::Panel& panel, const Law& law, double speed_factor) {
  double largest = -1;
  for (const render::figure::Series& series : panel.series) {
    if (series.style != render::figure::LineStyle::solid) continue;
    for (std::size_t i = 0; i < series.x.size(); ++i) {
      if (!std::isfinite(series.x[i]) || !std::isfinite(series.y[i])) continue;
      const double speed = series.x[i] / speed_factor;
      largest = larger_size(largest, series.y[i] - law.torque_Nm(speed));
    }
  }
  return largest < 0 ? std::numeric_limits<double>::quiet_NaN() : largest;
}

}  // namespace

Checks check_static_chart(const PapersJoint& joint, const figures::ReportFigure& drawn) {
  const friction::StribeckFriction& law = joint.laws.discontinuous;
  const render::figure::Panel& panel = drawn.figure.panels.at(0);
  double at_rest_Nm = 0;
  for (const render::figure::Series& series : panel.series) {
    if (series.marker == render::figure::Marker::none) continue;
    const auto [low, high] = std::minmax_element(series.y.begin(), series.y.end());
    at_rest_Nm = std::max(at_rest_Nm, *high - *low);
  }
  return {vanishing(tr("Points of the drawn line against eq. (1): largest difference"),
                    off_the_law(panel, law, 1.0), chart_rounding_Nm, "N·m", tr("rounding")),
          other_way(tr("The range drawn at rest: from −T_brk to T_brk"),
                    2 * law.curve().parameters().static_Nm, at_rest_Nm, 0, "N·m", "")};
}

Checks check_linear_zone_chart(const PapersJoint& joint, const figures::ReportFigure& drawn) {
  const friction::ThresholdSpeedFriction& law = joint.laws.continuous;
  const double threshold = law.parameters().threshold_rad_s;
  const std::vector<render::figure::Panel>& panels = drawn.figure.panels;
  const double milli = wording::prefixed("rad/s", threshold).factor;
  return {
      vanishing(tr("Points of the drawn line against eq. (2): largest difference"),
                off_the_law(panels.at(0), law, 1.0), chart_rounding_Nm, "N·m", tr("rounding")),
      vanishing(tr("The same in the close-up of the linear zone"),
                off_the_law(panels.at(1), law, milli), chart_rounding_Nm, "N·m", tr("rounding")),
      other_way(tr("Half of T_f(ω_th) does not hold the shaft: it creeps at this share of ω_th"),
                0.5, law.torque_Nm(threshold / 2) / law.torque_Nm(threshold), chart_rounding_Nm, "",
                tr("rounding"))};
}

Checks check_presliding_chart(const PapersJoint& joint) {
  constexpr double closed = 1e-6;
  Checks out;
  for (std::size_t i = 0; i < drawings::figure_5.size(); ++i) {
    const drawings::Swing& swing = drawings::figure_5.at(i);
    const simulate::PresetLoop& by_friction = joint.presliding.by_friction.at(i);
    const simulate::PreslidingLoop& by_force = joint.presliding.by_force.at(i);
    const std::string name = i == 0 ? tr("1st loop") : i == 1 ? tr("2nd loop") : tr("3rd loop");
    out.push_back(printed_value(
        tr("{loop}: friction over the travel at which table 1 gives the printed amplitude",
           {{"loop", name}}),
        swing.amplitude_N, 3, by_friction.largest_friction_N, drawings::last_place / 2, "N",
        tr("half of the last printed place")));
    out.push_back(
        in_words(tr("{loop}: friction of that amplitude is of pre-sliding", {{"loop", name}}),
                 Kind::print, swing.amplitude_N < joint.laws.contact.static_Nm,
                 tr("below the static force"), tr("not below the static force")));
    out.push_back(
        vanishing(tr("{loop}: gap where it closes, as a share of its friction", {{"loop", name}}),
                  by_friction.gap, closed, "", tr("closed to a millionth")));
    out.push_back(
        vanishing(tr("{loop} under a force: gap after the first cycle, as a share of its size",
                     {{"loop", name}}),
                  by_force.gap, closed, "", tr("closed to a millionth")));
    out.push_back(
        vanishing(tr("{loop} under a force: largest change with the solver's tolerance halved",
                     {{"loop", name}}),
                  by_force.tolerance_shift, closed, "", tr("nothing visible")));
  }
  return out;
}

// Figures 3, 4 and 6 to 8: drawings that are models.

namespace {

constexpr int states = 1000;

double between(statistics::RandomStream& random, double low, double high) {
  return low + (high - low) * random.uniform();
}

}  // namespace

Checks check_bristle_sketch(const figures::ReportFigure& drawn) {
  const render::figure::Diagram& diagram = present(drawn.figure.diagram);
  double sum = 0;
  int bristles = 0;
  double enlarged = 0;
  for (const render::figure::Stroke& stroke : diagram.strokes) {
    if (!(stroke.colour == drawings::bristle_colour)) continue;
    const double deflection = stroke.points.front().x - stroke.points.back().x;
    if (enlarged > 0) {  // the enlarged one is drawn last
      sum += enlarged;
      ++bristles;
    }
    enlarged = deflection;
  }
  const render::figure::Dimension& z = diagram.dimensions.at(0);
  const double dimension = z.to.x - z.from.x;
  return {other_way(tr_count(bristles,
                             "Mean deflection of the {bristles} bristle as drawn, against the z of "
                             "the enlarged one",
                             "Mean deflection of the {bristles} bristles as drawn, against the z "
                             "of the enlarged one",
                             {{"bristles", bristles}}),
                    dimension / drawings::enlargement_of_mean_bristle, sum / bristles, 0.01, "mm",
                    tr("the drawing's resolution")),
          other_way(tr("The dimension z spans the enlarged bristle's deflection"), enlarged,
                    dimension, 1e-9, "mm", tr("rounding"))};
}

Checks check_lugre_diagram(const PapersJoint& joint) {
  const friction::LuGreFriction& friction = bristles_of(joint.scenario);
  const drawings::SignalGraph graph = drawings::lugre_graph(friction);
  statistics::RandomStream random(4, 0);
  double rate_apart = 0;
  double torque_apart = 0;
  for (int i = 0; i < states; ++i) {
    const double speed = between(random, -20, 20);
    const double z = between(random, -1, 1) * friction.steady_deflection_rad(0);
    const drawings::SignalValues values =
        drawings::evaluate(graph, {{"speed", speed}}, {{"deflection", z}});
    const double rate = friction.deflection_rate_rad_s(z, speed);
    rate_apart = larger_size(rate_apart, values.at("rate") - rate);
    torque_apart =
        larger_size(torque_apart, values.at("friction") - friction.torque_Nm(z, rate, speed));
  }
  return {vanishing(tr("dz/dt through the drawn blocks against eq. (4), at 1000 states: largest"),
                    rate_apart, 1e-12, "rad/s", tr("rounding")),
          vanishing(tr("T_f through the drawn blocks against eq. (3): largest"), torque_apart,
                    1e-12, "N·m", tr("rounding"))};
}

Checks check_drive_diagram(const PapersJoint& joint) {
  const double n = joint.scenario.gear_ratio;
  const double J = joint.scenario.motor_inertia_kgm2;
  statistics::RandomStream random(6, 0);
  double apart = 0;
  for (int i = 0; i < states; ++i) {
    const double torque = between(random, -5, 5);
    const double friction = between(random, -1, 1);
    const double acceleration = between(random, -100, 100);
    const double drawn =
        drawings::evaluate(
            drawings::drive_graph({n, J, [friction](double) { return friction; }}),
            {{"motor torque", torque}, {"motor speed", 0}, {"motor acceleration", acceleration}})
            .at("arm torque");
    apart = larger_size(apart, drawn - n * (torque - J * acceleration - friction));
  }
  return {vanishing(tr("Through the drawn blocks against eq. (8), at 1000 states: largest"), apart,
                    1e-10, "N·m", tr("rounding"))};
}

Checks check_joint_diagram(const PapersJoint& joint) {
  const simulate::Scenario& s = joint.scenario;
  const joint::Recording& log = joint.recording(joint::Role::oscillation);
  double apart = 0;
  for (std::size_t i = 0; i < log.size(); ++i) {
    const double t = log.t_s[i];
    drawings::JointElements elements;
    elements.drive = {s.gear_ratio, s.motor_inertia_kgm2,
                      [&](double speed) { return s.sliding->torque_Nm(speed); }};
    elements.dynamic_friction_Nm = [&](double speed) {
      return bristles_of(s).torque_Nm(log.z_rad[i], log.dz_rad_s[i], speed);
    };
    elements.friction = drawings::FrictionChoice::dynamic;
    elements.arm_inertia_kgm2 = s.arm_inertia_kgm2;
    elements.load = s.load;
    const double n = s.gear_ratio;
    const double drawn =
        drawings::evaluate(drawings::joint_graph(elements),
                           {{"arm angle", log.q_rad[i]},
                            {"arm speed", joint.oscillation_speed_rad_s(t) / n},
                            {"arm acceleration", joint.oscillation_acceleration_rad_s2(t) / n}})
            .at("measured torque");
    apart = larger_size(apart, drawn - log.torque_Nm[i]);
  }
  return {
      vanishing(tr("Measured torque through the drawn blocks against the simulated log: largest"),
                apart, log_rounding_Nm, "N·m", tr(rounding_of_log))};
}

Checks check_gear_diagram(const PapersJoint& joint) {
  statistics::RandomStream random(8, 0);
  double lost = 0;
  for (int i = 0; i < states; ++i) {
    const double torque = between(random, -5, 5);
    const double turn = between(random, -5, 5);
    const drawings::SignalValues values = drawings::evaluate(
        drawings::gear_graph(joint.scenario.gear_ratio, joint.scenario.motor_inertia_kgm2),
        {{"shaft torque", torque}, {"motor angle", turn}, {"motor acceleration", 0}});
    lost = larger_size(lost, values.at("arm torque") * values.at("arm angle") - torque * turn);
  }
  return {vanishing(tr("An ideal gear loses no work, at 1000 states: largest loss"), lost, 1e-12,
                    "J", tr("rounding"))};
}

}  // namespace tribolog::paper::checks
