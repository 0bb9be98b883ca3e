#include "report/closing_values.h"

#include "report/element_values.h"
#include "report/view_parts.h"

namespace tribolog::report {
namespace {

TemplateValues& errata_section(const ErrataNumbers& e, TemplateValues& values) {
  TemplateValues& out = values.add_include("ERRATA", "errata.tpl");
  out.set("TORQUE_A", e.torque_A);
  out.set("MASS_A_PRINTED", e.mass_A_printed);
  out.set("MASS_A_500_MM", e.mass_A_with_500_mm);
  out.set("MASS_A_500_M", e.mass_A_with_500_m);
  out.set("MASS_A_N_BELOW", e.mass_A_with_n_below);
  out.set("MASS_A_ARM_N_BELOW", e.mass_A_arm_torque_with_n_below);
  out.set("LARGEST_DEVIATION", e.largest_deviation);
  out.set("ALLOWED_DEVIATION", e.allowed_deviation);
  out.set("COS_Q_C", e.cos_q_c);
  out.set("MASS_A_COS_Q_C", e.mass_A_with_cos_q_c);
  out.set("RAD_OF_22", e.rad_of_22);
  out.set("RAD_OF_PRECISE", e.rad_of_precise);
  out.set("CUT_OF_22", e.cut_of_22);
  out.set("CUT_OF_PRECISE", e.cut_of_precise);
  out.set("DEFLECTION_PRINTED", e.table_1_deflection_printed);
  out.set("DEFLECTION_MEANT", e.table_1_deflection_meant);
  out.set("DAMPING_MEANT", e.table_1_damping);
  out.set("BACKWARDS_SPEED", e.backwards_speed);
  out.set("EQUATION_1_MEANT", e.equation_1_meant);
  out.set("EQUATION_1_PRINTED", e.equation_1_printed);
  out.set("EQUATION_2_JUMP", e.equation_2_jump);
  out.set("EQUATION_2_HALF", e.equation_2_half);
  out.set("EQUATION_6_PRINTED", e.equation_6_printed);
  out.set("EQUATION_10_GRAVITY", e.equation_10_gravity);
  out.set("EQUATION_10_ERROR", e.equation_10_error);
  out.set("PAIR_MASSES", e.pair_masses);
  out.set("PAIR_SPREAD", e.pair_spread);
  out.set("SINGLE_SPREAD", e.single_spread);
  return out;
}

}  // namespace

void fill_errata(const ErrataNumbers& errata, const Table& paper_table, TemplateValues& values) {
  fill_table(paper_table, "TABLE", errata_section(errata, values));
}

void fill_errata(const ErrataNumbers& errata, const std::string& place_of_paper_table,
                 TemplateValues& values) {
  errata_section(errata, values).add_section("TABLE_ABOVE").set("PLACE", place_of_paper_table);
}

void fill_provenance(const std::string& command_line, const std::string& created_utc,
                     const std::vector<std::string>& notes, const std::vector<Table>& tables,
                     TemplateValues& values) {
  TemplateValues& out = values.add_include("PROVENANCE", "provenance.tpl");
  out.set("COMMAND_LINE", command_line);
  out.set("CREATED", created_utc);
  if (!notes.empty()) {
    TemplateValues& list = out.add_section("INPUT_NOTES");
    for (const std::string& note : notes) list.add_section("INPUT_NOTE").set("TEXT", or_dash(note));
  }
  for (const Table& table : tables) fill_table(table, "TABLE", out);
}

}  // namespace tribolog::report
