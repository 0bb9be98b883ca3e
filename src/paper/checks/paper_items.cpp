#include "paper/checks/paper_items.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "base/requirements.h"
#include "figures/figure_set.h"
#include "friction/catalogue.h"
#include "paper/charts/paper_charts.h"
#include "paper/checks/check.h"
#include "paper/checks/papers_joint.h"
#include "paper/drawings/paper_drawings.h"
#include "paper/drawings/printed_paper.h"
#include "paper/scenes/scene_figures.h"
#include "wording/tr.h"

namespace tribolog::paper::checks {

// What the paper concludes in words, held against the simulated joint.

namespace {

using method::hysteresis::Estimator;
using wording::tr;

Checks check_conclusions(const PapersJoint& joint) {
  const method::hysteresis::LoopPoint& chosen = joint.point(Estimator::B);
  const method::hysteresis::LoopTrace& trace = joint.calibration.curves.loops.at(0);
  const double largest_z = *std::max_element(trace.z_rad.begin(), trace.z_rad.end());
  const double truth = joint.true_mass_kg();
  const auto share_off = [&](Estimator estimator) {
    const method::hysteresis::SurrogateMass* mass = joint.calibration.masses.find(estimator);
    return mass != nullptr ? 100 * (mass->mass_kg.value / truth - 1) : NAN;
  };
  return {
      in_words(
          tr("The torque should be measured “while dropping the robot arms down”: the arm at B"),
          Origin::printed, joint.oscillation_speed_rad_s(chosen.t_s) < 0, tr("drops"), tr("rises")),
      vanishing(tr("“The value of asperities z(t) equals to the zero” there: z as a share of its "
                   "largest"),
                chosen.z_rad / largest_z, 2e-5, "", tr("read on a straight line between samples")),
      law_value(tr("Friction left in B: error of its mass"), 0, share_off(Estimator::B), 1, "%",
                tr("a single point still contains σ₁ dz/dt + σ₂ ω, and depends on the instant it "
                   "is read")),
      law_value(tr("No a priori knowledge is needed, and no z(t): error of the mid-line's mass"), 0,
                share_off(Estimator::midline), 0.01, "%", tr("what the program promises"))};
}

}  // namespace

// The paper's two tables, row by row.

namespace {

/// The six parameters that figure 5 is simulated with, against those that the paper cites.
Checks check_table_1();
/// Six torques of the simulated joint; six masses from the printed torques; six from its own.
Checks check_table_2(const PapersJoint& joint);

Checks check_table_1() {
  const friction::ContactParameters ours;
  const double values[] = {ours.stiffness_Nm_rad, ours.damping_Nms_rad, ours.viscous_Nms_rad,
                           ours.static_Nm,        ours.coulomb_Nm,      ours.stribeck_speed_rad_s};
  Checks out;
  std::size_t i = 0;
  for (const drawings::ContactRow& row : drawings::table_1) {
    const bool is_misprint = row.printed != row.meant;
    Check check = is_misprint
                      ? law_value(tr("{symbol}, as in the cited source", {{"symbol", row.symbol}}),
                                  row.meant, values[i], 1e-12 * row.meant, row.unit,
                                  tr("rounding; the printed value is a misprint, see the errata"))
                      : printed_value(row.symbol, row.meant, row.meant < 0.01 ? 3 : 1, values[i], 0,
                                      row.unit, "");
    out.push_back(check);
    ++i;
  }
  return out;
}

Checks check_table_2(const PapersJoint& joint) {
  Checks out;
  constexpr int places = 3;
  for (const drawings::TorqueRow& row : drawings::table_2) {
    const std::string point(1, row.point);
    const Estimator read_there = present(method::hysteresis::estimator_of(point));
    out.push_back(printed_value(tr("T at {point}, simulated joint", {{"point", point}}),
                                row.torque_Nm, places, joint.point(read_there).torque_Nm,
                                reconstruction_share * row.torque_Nm, "N·m", tr(reconstruction)));
  }
  for (const drawings::TorqueRow& row : drawings::table_2) {
    out.push_back(printed_value(
        tr("Mass {point} from the printed torque", {{"point", std::string(1, row.point)}}),
        row.mass_kg, places, drawings::mass_of_torque_kg(row.torque_Nm), drawings::rounding_kg(),
        "kg", tr("rounding of printed torque and mass")));
  }
  for (const drawings::TorqueRow& row : drawings::table_2) {
    const std::string point(1, row.point);
    const method::hysteresis::SurrogateMass* ours =
        joint.calibration.masses.find(method::hysteresis::estimator_of(point));
    out.push_back(printed_value(tr("Mass {point}, simulated joint", {{"point", point}}),
                                row.mass_kg, places,
                                ours != nullptr ? ours->mass_kg.value : std::nan(""),
                                reconstruction_share * row.mass_kg, "kg", tr(reconstruction)));
  }
  return out;
}

PaperItem equation(int number, std::string title, Checks checks, std::string remark = "") {
  return {ItemKind::equation, number, std::move(title), std::move(remark), std::move(checks)};
}

PaperItem table(int number, std::string title, Checks checks, std::string remark = "") {
  return {ItemKind::table, number, std::move(title), std::move(remark), std::move(checks)};
}

class Figures {
 public:
  explicit Figures(const std::vector<figures::ReportFigure>& figures) : figures_(figures) {}
  const figures::ReportFigure& operator[](int number) const {
    const auto found =
        std::find_if(figures_.begin(), figures_.end(),
                     [&](const figures::ReportFigure& f) { return f.number == number; });
    if (found == figures_.end()) {
      throw std::invalid_argument("the paper's figure " + std::to_string(number) + " is missing");
    }
    return *found;
  }
  [[nodiscard]] PaperItem item(int number, Checks checks, std::string remark = "") const {
    return {ItemKind::figure, number, (*this)[number].title, std::move(remark), std::move(checks)};
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
                 tr("In print exponents and dots are lost.")),
        equation(7, tr("The same, smooth through rest"), check_equation_7(joint))}},
      {"2.2",
       tr("Dynamical friction model"),
       {figure.item(4, check_lugre_diagram(joint)),
        table(1, tr("Parameters of the LuGre model"), check_table_1(),
              tr("In print σ₀ = 1·10⁻⁵ N/m and σ₁ = 1·10⁻¹⁰ N·s/m.")),
        figure.item(5, check_presliding_chart(joint))}},
      {"2.3",
       tr("Model of the driving system in the third robot joint"),
       {figure.item(6, check_drive_diagram(joint)),
        equation(8, tr("The drive: motor torque, inertia, friction, arm"), check_equation_8(joint)),
        figure.item(7, check_joint_diagram(joint)), figure.item(8, check_gear_diagram(joint))}},
      {"3",
       tr("Friction measurement technique"),
       {figure.item(9, check_robot(joint),
                    tr("A photograph in print; here drawn from the robot's description.")),
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
       {figure.item(11, check_sweep_motion(joint)), figure.item(12, check_motion_range(joint)),
        figure.item(13, check_rough_peak(joint), tr("Printed result: −22° = 0.383 rad.")),
        figure.item(14, check_precise_peak(joint),
                    tr("Printed result: −22.23187° = 0.38801 rad."))}},
      {"3.3",
       tr("Gravity's torque at the motor shaft"),
       {equation(13, tr("Largest torque of the sweep"), check_equation_13(joint)),
        figure.item(15, check_torque_loop(joint)), figure.item(16, check_deflection_loop(joint)),
        figure.item(17, check_rate_loop(joint)),
        table(2, tr("Driving torques and surrogate masses"), check_table_2(joint),
              tr("In print r = 500 m; the rows hold for 0.5 m."))}},
      {"3.4",
       tr("Viscous friction in the third robot joint"),
       {figure.item(18, check_candidate_curves(joint)),
        figure.item(19, check_reference_curve(joint)), figure.item(20, check_quality_errors(joint)),
        figure.item(21, check_selected_curve(joint)), figure.item(22, check_torque_choice(joint)),
        equation(14, tr("Corrected angle of the centre of gravity"), check_equation_14(joint))}},
      {"4",
       tr("Conclusion"),
       {{ItemKind::statement, 0, tr("What the paper concludes"), "", check_conclusions(joint)}}},
  };
}

const char* key_of(ItemKind kind) {
  switch (kind) {
    case ItemKind::figure:
      return "figure";
    case ItemKind::table:
      return "table";
    case ItemKind::equation:
      return "equation";
    case ItemKind::statement:
      break;
  }
  return "statement";
}

Tally tally_checks(const Checks& checks) {
  return {static_cast<int>(checks.size()),
          static_cast<int>(std::count_if(checks.begin(), checks.end(),
                                         [](const Check& check) { return check.holds(); }))};
}

bool every_check_holds(const PaperItem& item) {
  const Tally checks = tally_checks(item.checks);
  return checks.there > 0 && checks.hold == checks.there;
}

Tally tally_checks(const std::vector<PaperSection>& sections) {
  Tally sum;
  for (const PaperSection& section : sections) {
    for (const PaperItem& item : section.items) {
      const Tally checks = tally_checks(item.checks);
      sum.there += checks.there;
      sum.hold += checks.hold;
    }
  }
  return sum;
}

std::vector<figures::ReportFigure> paper_figures(const PapersJoint& joint) {
  std::vector<figures::ReportFigure> figures{charts::static_friction_figure(joint.discontinuous),
                                             charts::linear_zone_figure(joint.continuous),
                                             charts::presliding_hysteresis_figure(joint.loops)};
  const auto add = [&](std::vector<figures::ReportFigure> more) {
    std::move(more.begin(), more.end(), std::back_inserter(figures));
  };
  add(drawings::paper_drawings(joint.scenario.gear_ratio));
  add(scenes::scene_figures(joint.robot));
  add(figures::figure_set(joint.dataset, joint.calibration));
  std::sort(figures.begin(), figures.end(),
            [](const figures::ReportFigure& a, const figures::ReportFigure& b) {
              return a.number < b.number;
            });
  return figures;
}

}  // namespace tribolog::paper::checks
