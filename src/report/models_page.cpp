#include "report/models_page.h"

#include "report/element_values.h"
#include "report/page_style.h"
#include "report/view_parts.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::report {
namespace {

using wording::tr;

Table models_table() {
  Table table;
  table.id = "table-models";
  table.caption = tr("What each model is claimed to show, in order of publication");
  table.columns = {{tr("Model"), "", false},        {tr("Name in a scenario"), "", false},
                   {tr("Source"), "", false, true}, {tr("Pre-sliding"), "", false},
                   {tr("Break-away"), "", false},   {tr("Stribeck"), "", false},
                   {tr("Lag"), "", false},          {tr("Non-local memory"), "", false},
                   {tr("Drifts"), "", false},       {tr("Rate independent"), "", false}};
  const auto word = [](bool shows) { return shows ? tr("yes") : std::string("–"); };
  for (const friction::FrictionModelEntry& one : friction::dynamic_friction_models()) {
    const friction::FrictionTraits& t = one.traits;
    table.rows.push_back({{wording::words_for("friction_model", one.name), one.name,
                           wording::words_for("friction_source", one.name), word(t.presliding),
                           word(t.break_away), word(t.stribeck), word(t.lag),
                           word(t.non_local_memory), word(t.drifts), word(t.rate_independent)},
                          false});
  }
  table.note =
      tr("Break-away: more torque to start than to keep sliding. Drifts: creeps under an "
         "oscillating torque that stays below break-away. Tests hold each model to its row.");
  return table;
}

std::vector<Fact> contact_facts(const friction::ContactParameters& c) {
  constexpr int digits = 4;
  const auto fact = [](const std::string& name, double value, const char* unit) {
    return Fact{name, wording::with_unit(wording::significant(value, digits), unit)};
  };
  return {fact(tr("Stiffness"), c.stiffness_Nm_rad, "N/m"),
          fact(tr("Damping"), c.damping_Nms_rad, "N·s/m"),
          fact(tr("Viscous coefficient"), c.viscous_Nms_rad, "N·s/m"),
          fact(tr("Break-away force"), c.static_Nm, "N"),
          fact(tr("Coulomb force"), c.coulomb_Nm, "N"),
          fact(tr("Stribeck velocity"), c.stribeck_speed_rad_s, "m/s")};
}

}  // namespace

std::string models_page(const friction::ContactParameters& contact,
                        const std::vector<figures::ModelExperiment>& experiments,
                        const std::vector<render::workers::DrawnFigure>& drawn,
                        const calibration::Provenance& provenance, wording::Language language) {
  const wording::WordsIn words(language);
  TemplateValues values;
  fill_head(provenance, values);
  fill_facts(contact_facts(contact), values);
  fill_table(models_table(), "TABLE", values);
  for (const figures::ModelExperiment& experiment : experiments) {
    TemplateValues& entry = values.add_section("CONTENTS_ENTRY");
    entry.set("SECTION_ID", experiment.id);
    entry.set("TITLE", experiment.title);
    TemplateValues& section = values.add_section("EXPERIMENT");
    section.set("SECTION_ID", experiment.id);
    section.set("TITLE", experiment.title);
    section.set("EXPLANATION", experiment.explanation);
    for (const FigureCard& card : figure_cards(experiment.figures, drawn)) {
      fill_figure(card, section);
    }
  }
  return expand_template("models.tpl", values, language);
}

}  // namespace tribolog::report
