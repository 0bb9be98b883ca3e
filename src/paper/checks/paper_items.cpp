#include "paper/checks/paper_items.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "base/enum_text.h"
#include "base/requirements.h"
#include "figures/figure_set.h"
#include "friction/catalogue.h"
#include "paper/charts/paper_charts.h"
#include "paper/checks/check.h"
#include "paper/checks/future_work.h"
#include "paper/checks/loop_torques.h"
#include "paper/checks/papers_joint.h"
#include "paper/drawings/paper_drawings.h"
#include "paper/drawings/printed_paper.h"
#include "paper/scenes/scene_figures.h"
#include "wording/rounding.h"
#include "wording/tr.h"

namespace tribolog::paper::checks {

// What the paper concludes in words, held against the simulated joint.

namespace {

using method::hysteresis::Estimator;
using wording::tr;
using wording::with_unit;

/// Error of an estimator's mass [%].
double error_percent(const PapersJoint& joint, Estimator estimator) {
  const method::hysteresis::SurrogateMass* mass = joint.calibration.masses.find(estimator);
  return mass != nullptr ? 100 * (mass->mass_kg.value / joint.true_mass_kg() - 1) : NAN;
}

std::string percent_text(double percent) { return with_unit(wording::fixed(percent, 2), "%"); }

Checks check_conclusions(const PapersJoint& joint) {
  const bool is_dropping_better =
      std::abs(error_percent(joint, Estimator::B)) < std::abs(error_percent(joint, Estimator::A));
  return {in_words(tr("The torque should be measured “while dropping the robot arms down”: of the "
                      "two instants at which z = 0, the one with the smaller error of the mass"),
                   Kind::print, is_dropping_better, tr("dropping"), tr("rising"))};
}

std::vector<std::string> unchecked_in_conclusions(const PapersJoint& joint) {
  return {
      tr("“The measurement falls at the moment in which the value of asperities equals zero”: B "
         "is that moment while the arm drops. Friction left there, σ₁ dz/dt + σ₂ ω, puts its "
         "mass off by {error_B}; that of the mid-line is off by {error_midline}, and needs no "
         "z(t).",
         {{"error_B", percent_text(error_percent(joint, Estimator::B))},
          {"error_midline", percent_text(error_percent(joint, Estimator::midline))}})};
}

}  // namespace

// The paper's two tables, row by row.

namespace {

std::vector<std::string> remarks_on_table_1() {
  std::vector<std::string> out;
  for (const drawings::ContactRow& row : drawings::table_1) {
    const std::string meant = with_unit(wording::as_stated(row.meant), row.unit);
    out.push_back(
        row.printed == row.meant
            ? tr("{symbol} = {value}, as printed", {{"symbol", row.symbol}, {"value", meant}})
            : tr("{symbol} = {value}, as in the cited source; {printed} in print is a "
                 "misprint",
                 {{"symbol", row.symbol},
                  {"value", meant},
                  {"printed", with_unit(wording::as_stated(row.printed), row.unit)}}));
  }
  return out;
}

/// Six torques of the simulated joint; six masses from the printed torques.
Checks check_table_2(const PapersJoint& joint) {
  Checks out;
  constexpr int places = 3;
  for (const drawings::TorqueRow& row : drawings::table_2) {
    const std::string point(1, row.point);
    const Estimator read_there = present(method::hysteresis::estimator_of(point));
    out.push_back(printed_value(tr("T at {point}", {{"point", point}}), row.torque_Nm, places,
                                joint.point(read_there).torque_Nm, drawings::half_smallest_gap_Nm(),
                                "N·m",
                                tr("half of the smallest difference between two printed torques: "
                                   "closer to its own than to any other")));
  }
  const simulate::Scenario& s = joint.scenario;
  for (const drawings::TorqueRow& row : drawings::table_2) {
    out.push_back(printed_value(
        tr("Mass {point} from the printed torque", {{"point", std::string(1, row.point)}}),
        row.mass_kg, places,
        joint::surrogate_mass_kg(row.torque_Nm, s.gear_ratio, s.surrogate_distance_m,
                                 s.load.gravity_m_s2(), 1.0),
        drawings::rounding_kg(), "kg", tr("rounding of printed torque and mass")));
  }
  return out;
}

/// Largest difference of six torques, in the order A to F, from table 2's [%].
template <class Torques>
double largest_from_table_2(const Torques& torques_Nm) {
  double largest = 0;
  for (std::size_t i = 0; i < drawings::table_2.size(); ++i) {
    largest = larger_size(largest, 100 * (torques_Nm[i] / drawings::table_2.at(i).torque_Nm - 1));
  }
  return largest;
}

/// The joint with a contact so stiff that its loop is all but a rectangle: the numbers for which
/// the closed form comes closest to table 2 in the largest of the six differences.
simulate::Scenario stiffer_joint(const simulate::Scenario& scenario) {
  constexpr double gravity_Nm = 3.88066079;
  constexpr double static_Nm = 0.8840618;
  constexpr double swing_in_deflections = 22.08260967;
  constexpr double rate_torque_Nm = 0.04805773;
  simulate::Scenario stiffer = scenario;
  const simulate::OscillationExperiment& e = present(scenario.oscillation);
  const double swing = scenario.gear_ratio * e.amplitude_rad;
  friction::LuGreFriction::Parameters p = bristles_of(scenario).parameters();
  p.static_Nm = static_Nm;
  p.bristle_stiffness_Nm_rad = swing_in_deflections * static_Nm / swing;
  p.bristle_damping_Nms_rad =
      rate_torque_Nm / (2 * std::numbers::pi * e.frequency_Hz * swing) - p.viscous_Nms_rad;
  stiffer.presliding = std::make_shared<friction::LuGreFriction>(p);
  const joint::GravityLoad& load = scenario.load;
  stiffer.load = joint::GravityLoad(
      gravity_Nm * scenario.gear_ratio / (load.gravity_m_s2() * load.distance_m()),
      load.distance_m(), load.q_peak_rad(), load.gravity_m_s2());
  return stiffer;
}

std::vector<std::string> unchecked_of_table_2(const PapersJoint& joint) {
  std::array<double, 6> torques_Nm{};
  for (std::size_t i = 0; i < torques_Nm.size(); ++i) {
    torques_Nm.at(i) = joint.point(method::hysteresis::loop_points.at(i)).torque_Nm;
  }
  return {
      tr("Print gives no parameter of the joint. Four of its numbers, G/n, T_s, σ₀ n a/T_s and "
         "(σ₁ + σ₂) n a 2πf, are chosen so that its six torques come close to print; the largest "
         "difference is {largest_difference}. Six torques less four numbers leave two that test "
         "the model.",
         {{"largest_difference",
           with_unit(wording::fixed(largest_from_table_2(torques_Nm), 3), "%")}}),
      tr("The table does not fix them: with a bristle stiffness 4.2 times as large the closed form "
         "comes as close as {largest_difference}.",
         {{"largest_difference",
           with_unit(
               wording::fixed(
                   largest_from_table_2(plain_loop_torques_Nm(stiffer_joint(joint.scenario))), 3),
               "%")}})};
}

std::vector<std::string> unchecked_of_points(const PapersJoint& joint) {
  const friction::LuGreFriction::Parameters& p = bristles_of(joint.scenario).parameters();
  const double top_speed = joint.oscillation_speed_rad_s(0);
  const double bias_Nm = (p.bristle_damping_Nms_rad + p.viscous_Nms_rad) * top_speed;
  return {tr("A and B are where z = 0, while the arm rises and while it drops; C and D are z's "
             "largest and smallest value. These definitions are not the paper's, which gives none: "
             "with them its table 2 comes back."),
          tr("A is read at the start, from rest, where z = 0: there the ideal drive jumps to its "
             "full speed of {speed}, and (σ₁ + σ₂) ω = {bias} is what makes A too large.",
             {{"speed", with_unit(wording::significant(top_speed, 3), "rad/s")},
              {"bias", with_unit(wording::significant(bias_Nm, 3), "N·m")}})};
}

std::vector<std::string> unchecked_of_rates() {
  return {
      tr("E and F are where dz/dt is largest while z < 0, and smallest while z > 0. The "
         "largest dz/dt of all is at A: there the drive jumps from rest to its full speed, and "
         "the bristles with it.")};
}

/// What the rough sweep leaves out, and why.
std::vector<std::string> unchecked_of_sweep(const PapersJoint& joint) {
  const joint::Recording& log = joint.recording(joint::Role::rough_sweep);
  const double planned = present(joint.scenario.rough_sweep).speed_rad_s;
  constexpr double constant = 1e-6;  // of the speed
  const auto unsteady =
      std::count_if(log.dq_rad_s.begin(), log.dq_rad_s.end(), [&](double speed_rad_s) {
        return std::abs(std::abs(speed_rad_s) - planned) > constant * planned;
      });
  return {
      tr("Of {samples} samples {left_out} are left out: {unsteady} are not at constant speed, "
         "the others are the first and last twentieth of each stroke, in which a real drive "
         "still settles.",
         {{"samples", log.size()},
          {"left_out", joint.calibration.rough.samples_left_out},
          {"unsteady", unsteady}})};
}

std::vector<std::string> unchecked_of_presliding() {
  return {
      tr("Amplitudes ±1.425 N, ±1.3 N, ±1 N and frequencies 1 Hz, 10 Hz, 25 Hz are taken from "
         "print.")};
}

PaperItem equation(int number, std::string title, Checks checks, std::string remark = "",
                   std::vector<std::string> unchecked = {}) {
  return {ItemKind::equation,  number, std::move(title), std::move(remark), std::move(checks),
          std::move(unchecked)};
}

PaperItem table(int number, std::string title, Checks checks, std::string remark,
                std::vector<std::string> unchecked) {
  return {ItemKind::table,     number, std::move(title), std::move(remark), std::move(checks),
          std::move(unchecked)};
}

/// What is drawn that print does not show, and why; empty: nothing.
std::string drawn_otherwise(int figure) {
  switch (figure) {
    case 2:
      return tr("Added: the linear zone enlarged, which is too narrow to be seen.");
    case 5:
      return tr("Added: the loops under a force, for print speaks of both.");
    case 9:
      return tr("Drawn from the robot's description in place of a photograph.");
    case 11:
    case 13:
    case 14:
      return tr("Added: the way back, for in the mean of both directions friction cancels.");
    case 15:
    case 16:
    case 17:
      return tr("Added: the same over time, and the steady loop that follows the first strokes.");
    case 18:
    case 21:
      return tr("Added: the curve by the mid-line's mass, and both directions.");
    case 19:
    case 20:
      return tr("Added: a close-up of the candidates that are near the reference.");
    case 22:
      return tr("Added: the mid-line of the steady loop, and a close-up around it.");
    default:
      return "";
  }
}

class Figures {
 public:
  explicit Figures(const std::vector<figures::ReportFigure>& figures) : figures_(figures) {}
  const figures::ReportFigure& operator[](int number) const {
    const auto found =
        std::find_if(figures_.begin(), figures_.end(),
                     [&](const figures::ReportFigure& f) { return f.paper_number == number; });
    if (found == figures_.end()) {
      throw std::invalid_argument("the paper's figure " + std::to_string(number) + " is missing");
    }
    return *found;
  }
  [[nodiscard]] PaperItem item(int number, Checks checks, std::string remark = "",
                               std::vector<std::string> unchecked = {}) const {
    std::string remarks = drawn_otherwise(number);
    if (!remarks.empty() && !remark.empty()) remarks += " ";
    return {ItemKind::figure,
            number,
            (*this)[number].title,
            remarks + remark,
            std::move(checks),
            std::move(unchecked),
            drawings::figure_captions.at(static_cast<std::size_t>(number) - 1)};
  }

 private:
  const std::vector<figures::ReportFigure>& figures_;
};

}  // namespace

std::vector<PaperSection> paper_items(const PapersJoint& joint,
                                      const std::vector<figures::ReportFigure>& figures) {
  const Figures figure(figures);
  return {
      {"1",
       tr("Introduction"),
       {equation(1, tr("Static friction with Stribeck effect"), check_equation_1(joint),
                 tr("In print sgn(ω) stands on a line of its own.")),
        figure.item(1, check_static_chart(joint, figure[1])),
        equation(2, tr("Static friction with a threshold speed"), check_equation_2(joint),
                 tr("In print both branches are said to hold for |ω| ≥ ω_th.")),
        figure.item(2, check_linear_zone_chart(joint, figure[2])),
        figure.item(3, check_bristle_sketch(figure[3])),
        equation(3, tr("LuGre: friction torque"), check_equation_3(joint)),
        equation(4, tr("LuGre: rate of the bristle deflection"), check_equation_4(joint)),
        equation(5, tr("LuGre: Stribeck curve"), check_equation_5(joint))}},
      {"2.1",
       tr("Static friction model"),
       {equation(6, tr("Friction of a geared joint"), check_equation_6(joint),
                 tr("In print one speed reads q_e.")),
        equation(7, tr("The same, smooth through rest"), check_equation_7(joint), "",
                 {tr("c = 10⁶ s/rad is taken from print.")})}},
      {"2.2",
       tr("Dynamical friction model"),
       {figure.item(4, check_lugre_diagram(joint)),
        table(1, tr("Parameters of the LuGre model"), {},
              tr("In print σ₀ = 1·10⁻⁵ N/m and σ₁ = 1·10⁻¹⁰ N·s/m."), remarks_on_table_1()),
        figure.item(5, check_presliding_chart(joint), "", unchecked_of_presliding())}},
      {"2.3",
       tr("Model of the driving system in the third robot joint"),
       {figure.item(6, check_drive_diagram(joint)),
        equation(8, tr("The drive: motor torque, inertia, friction, arm"), check_equation_8(joint),
                 "", {tr("n₃ = 100 is taken from print.")}),
        figure.item(7, check_joint_diagram(joint)), figure.item(8, check_gear_diagram(joint))}},
      {"3",
       tr("Friction measurement technique"),
       {figure.item(9, check_robot(joint), "",
                    {tr("Robot and joint are those of print: FANUC AM100iB, joint 3.")}),
        equation(9, tr("Gravity's torque at the arm"), check_equation_9(joint)),
        equation(10, tr("The drive in uniform motion"), check_equation_10(joint),
                 tr("In print cos(q₃), where eq. (9) has cos(q_c + q₃).")),
        equation(11, tr("Friction from the driving torque"), check_equation_11(joint),
                 tr("In print cos(q₃), as in eq. (10)."))}},
      {"3.1",
       tr("Surrogate mass and its centre of gravity"),
       {figure.item(10, check_mass_model(joint)),
        equation(12, tr("Surrogate mass"), check_equation_12(joint),
                 tr("In print n stands in the denominator, and the cosine is of q_c."))}},
      {"3.2",
       tr("Angular position of the centre of gravity"),
       {figure.item(11, check_sweep_motion(joint), "", unchecked_of_sweep(joint)),
        figure.item(12, check_motion_range(joint)),
        figure.item(13, check_rough_peak(joint), tr("Printed result: −22° = 0.383 rad.")),
        figure.item(14, check_precise_peak(joint),
                    tr("Printed result: −22.23187° = 0.38801 rad."))}},
      {"3.3",
       tr("Gravity's torque at the motor shaft"),
       {equation(13, tr("Largest torque of the sweep"), check_equation_13(joint)),
        figure.item(
            15, check_torque_loop(joint), "",
            {tr("Its six torques are those of table 2, and are compared with print there.")}),
        figure.item(16, check_deflection_loop(joint), "", unchecked_of_points(joint)),
        figure.item(17, check_rate_loop(joint), "", unchecked_of_rates()),
        table(2, tr("Driving torques and surrogate masses"), check_table_2(joint),
              tr("In print r = 500 m; the rows hold for 0.5 m."), unchecked_of_table_2(joint))}},
      {"3.4",
       tr("Viscous friction in the third robot joint"),
       {figure.item(18, check_candidate_curves(joint)),
        figure.item(19, check_reference_curve(joint)), figure.item(20, check_quality_errors(joint)),
        figure.item(
            21, check_selected_curve(joint), "",
            {tr("The selected mass, 78.811 kg, and torque, 3.866 N·m, are row B of table 2.")}),
        figure.item(22, check_torque_choice(joint)),
        equation(14, tr("Corrected angle of the centre of gravity"), check_equation_14(joint))}},
      {"4",
       tr("Conclusion"),
       {{ItemKind::statement, 0, tr("What the paper concludes"), "", check_conclusions(joint),
         unchecked_in_conclusions(joint)},
        check_future_work(joint)}},
  };
}

std::vector<PaperItem> items_of_print(const PapersJoint& joint) {
  const auto figure = [](int number, Checks checks) {
    return PaperItem{ItemKind::figure, number, "", "", std::move(checks), {}};
  };
  return {equation(2, "", check_equation_2(joint)),
          equation(7, "", check_equation_7(joint)),
          figure(5, check_presliding_chart(joint)),
          figure(11, check_sweep_motion(joint)),
          figure(13, check_rough_peak(joint)),
          figure(14, check_precise_peak(joint)),
          table(2, "", check_table_2(joint), "", {}),
          figure(20, check_quality_errors(joint)),
          equation(14, "", check_equation_14(joint)),
          {ItemKind::statement, 0, "", "", check_conclusions(joint), {}}};
}

std::string item_name(const PaperItem& item) {
  switch (item.kind) {
    case ItemKind::figure:
      return tr("Figure {number}", {{"number", item.number}});
    case ItemKind::table:
      return tr("Table {number}", {{"number", item.number}});
    case ItemKind::equation:
      return tr("Equation {number}", {{"number", item.number}});
    case ItemKind::statement:
      break;
  }
  return item.number == 0 ? tr("The conclusions") : tr("Future work");
}

std::string key_of(ItemKind kind) { return own_name(kind); }

Tally tally_checks(const Checks& checks) {
  return {static_cast<int>(checks.size()),
          static_cast<int>(std::count_if(checks.begin(), checks.end(),
                                         [](const Check& check) { return check.holds(); }))};
}

Tally tally_checks(const Checks& checks, Kind kind) {
  Tally out;
  for (const Check& check : checks) {
    if (check.kind != kind) continue;
    ++out.there;
    out.hold += check.holds() ? 1 : 0;
  }
  return out;
}

bool every_check_holds(const PaperItem& item) {
  const Tally checks = tally_checks(item.checks);
  return checks.hold == checks.there;
}

namespace {

template <class Use>
void for_each_item(const std::vector<PaperSection>& sections, Use use) {
  for (const PaperSection& section : sections) {
    for (const PaperItem& item : section.items) use(item);
  }
}

}  // namespace

Tally tally_checks(const std::vector<PaperSection>& sections, Kind kind) {
  Tally sum;
  for_each_item(sections, [&](const PaperItem& item) {
    const Tally checks = tally_checks(item.checks, kind);
    sum.there += checks.there;
    sum.hold += checks.hold;
  });
  return sum;
}

std::vector<const Check*> print_checks(const std::vector<PaperSection>& sections) {
  std::vector<const Check*> out;
  for_each_item(sections, [&](const PaperItem& item) {
    for (const Check& check : item.checks) {
      if (check.kind == Kind::print) out.push_back(&check);
    }
  });
  return out;
}

int to_the_last_place(const std::vector<PaperSection>& sections) {
  int count = 0;
  for (const Check* check : print_checks(sections)) {
    const std::optional<double> off = check->in_last_places();
    count += off && std::abs(*off) < 1 ? 1 : 0;
  }
  return count;
}

int count_unchecked(const std::vector<PaperSection>& sections) {
  std::size_t count = 0;
  for_each_item(sections, [&](const PaperItem& item) { count += item.unchecked.size(); });
  return static_cast<int>(count);
}

std::vector<figures::ReportFigure> paper_figures(const PapersJoint& joint) {
  std::vector<figures::ReportFigure> figures{
      charts::static_friction_figure(joint.laws.discontinuous),
      charts::linear_zone_figure(joint.laws.continuous),
      charts::presliding_hysteresis_figure(joint.presliding)};
  const auto add = [&](std::vector<figures::ReportFigure> more) {
    std::move(more.begin(), more.end(), std::back_inserter(figures));
  };
  add(drawings::paper_drawings(joint.scenario.gear_ratio));
  add(scenes::scene_figures(joint.robot));
  add(figures::figure_set(joint.dataset, joint.calibration));
  std::sort(figures.begin(), figures.end(),
            [](const figures::ReportFigure& a, const figures::ReportFigure& b) {
              return a.paper_number < b.paper_number;
            });
  return figures;
}

}  // namespace tribolog::paper::checks
