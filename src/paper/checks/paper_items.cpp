#include "paper/checks/paper_items.h"

#include <algorithm>
#include <stdexcept>

#include "paper/checks/conclusion_checks.h"
#include "paper/checks/equation_checks.h"
#include "paper/checks/figure_checks.h"
#include "paper/checks/table_checks.h"

namespace tribolog::paper {
namespace {

PaperItem equation(int number, std::string title, Checks checks, std::string remark = "") {
  return {ItemKind::equation, number, std::move(title), std::move(remark), std::move(checks)};
}

PaperItem table(int number, std::string title, Checks checks, std::string remark = "") {
  return {ItemKind::table, number, std::move(title), std::move(remark), std::move(checks)};
}

class Figures {
 public:
  explicit Figures(const std::vector<ReportFigure>& figures) : figures_(figures) {}
  const ReportFigure& operator[](int number) const {
    const auto found = std::find_if(figures_.begin(), figures_.end(),
                                    [&](const ReportFigure& f) { return f.number == number; });
    if (found == figures_.end()) {
      throw std::invalid_argument("the paper's figure " + std::to_string(number) + " is missing");
    }
    return *found;
  }
  [[nodiscard]] PaperItem item(int number, Checks checks, std::string remark = "") const {
    return {ItemKind::figure, number, (*this)[number].title, std::move(remark), std::move(checks)};
  }

 private:
  const std::vector<ReportFigure>& figures_;
};

}  // namespace

std::vector<PaperSection> paper_items(const PapersJoint& joint,
                                      const std::vector<ReportFigure>& figures) {
  const Figures figure(figures);
  return {
      {"1",
       "Introduction",
       {equation(1, "Static friction with Stribeck effect", check_equation_1(joint),
                 "In print sgn(ω) stands on a line of its own."),
        figure.item(1, check_static_chart(joint, figure[1])),
        equation(2, "Static friction with a threshold speed", check_equation_2(joint),
                 "In print both branches are said to hold for |ω| ≥ ω_th."),
        figure.item(2, check_linear_zone_chart(joint, figure[2])),
        figure.item(3, check_bristle_sketch(figure[3])),
        equation(3, "LuGre: friction torque", check_equation_3(joint)),
        equation(4, "LuGre: rate of the bristle deflection", check_equation_4(joint)),
        equation(5, "LuGre: Stribeck curve", check_equation_5(joint))}},
      {"2.1",
       "Static friction model",
       {equation(6, "Friction of a geared joint", check_equation_6(joint),
                 "In print exponents and dots are lost."),
        equation(7, "The same, smooth through rest", check_equation_7(joint))}},
      {"2.2",
       "Dynamical friction model",
       {figure.item(4, check_lugre_diagram(joint)),
        table(1, "Parameters of the LuGre model", check_table_1(),
              "In print σ₀ = 1·10⁻⁵ N/m and σ₁ = 1·10⁻¹⁰ N·s/m."),
        figure.item(5, check_presliding_chart(joint))}},
      {"2.3",
       "Model of the driving system in the third robot joint",
       {figure.item(6, check_drive_diagram(joint)),
        equation(8, "The drive: motor torque, inertia, friction, arm", check_equation_8(joint)),
        figure.item(7, check_joint_diagram(joint)), figure.item(8, check_gear_diagram(joint))}},
      {"3",
       "Friction measurement technique",
       {figure.item(9, check_robot(joint),
                    "In print a photograph; here drawn from the robot's description."),
        equation(9, "Gravity's torque at the arm", check_equation_9(joint)),
        equation(10, "The drive in uniform motion", check_equation_10(joint),
                 "In print cos(q₃), where eq. (9) has cos(q_c + q₃)."),
        equation(11, "Friction from the driving torque", check_equation_11(joint),
                 "In print cos(q₃), as in eq. (10).")}},
      {"3.1",
       "Surrogate mass and its centre of gravity",
       {figure.item(10, check_mass_model(joint)),
        equation(12, "Surrogate mass", check_equation_12(joint),
                 "In print n stands in the denominator, and the cosine is that of q_c.")}},
      {"3.2",
       "Angular position of the centre of gravity",
       {figure.item(11, check_sweep_motion(joint)), figure.item(12, check_motion_range(joint)),
        figure.item(13, check_rough_peak(joint), "Printed result: −22° = 0.383 rad."),
        figure.item(14, check_precise_peak(joint), "Printed result: −22.23187° = 0.38801 rad.")}},
      {"3.3",
       "Gravity's torque at the motor shaft",
       {equation(13, "Largest torque of the sweep", check_equation_13(joint)),
        figure.item(15, check_torque_loop(joint)), figure.item(16, check_deflection_loop(joint)),
        figure.item(17, check_rate_loop(joint)),
        table(2, "Driving torques and surrogate masses", check_table_2(joint),
              "In print r = 500 m; the rows hold for 0.5 m.")}},
      {"3.4",
       "Viscous friction in the third robot joint",
       {figure.item(18, check_candidate_curves(joint)),
        figure.item(19, check_reference_curve(joint)), figure.item(20, check_quality_errors(joint)),
        figure.item(21, check_selected_curve(joint)), figure.item(22, check_torque_choice(joint)),
        equation(14, "Corrected angle of the centre of gravity", check_equation_14(joint))}},
      {"4",
       "Conclusion",
       {{ItemKind::statement, 0, "What the paper concludes", "", check_conclusions(joint)}}},
  };
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

}  // namespace tribolog::paper
