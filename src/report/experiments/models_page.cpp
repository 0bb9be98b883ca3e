#include "report/experiments/models_page.h"

#include "report/elements/element_values.h"
#include "report/elements/elements.h"
#include "report/elements/figure_cards.h"
#include "report/engine/page_style.h"
#include "report/engine/template_engine.h"
#include "wording/rounding.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::report::experiments {
namespace {

using wording::tr;

elements::Table models_table() {
  elements::Table table;
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

std::vector<elements::Fact> contact_facts(const friction::ContactParameters& c) {
  constexpr int digits = 4;
  const auto fact = [](const std::string& name, double value, const char* unit) {
    return elements::Fact{name, wording::with_unit(wording::significant(value, digits), unit)};
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
                        const std::vector<figures::experiments::ModelExperiment>& experiments,
                        const std::vector<render::workers::DrawnFigure>& drawn,
                        const calibration::Provenance& provenance, wording::Language language) {
  const wording::WordsIn words(language);
  engine::TemplateValues values;
  engine::fill_head(provenance, values);
  elements::fill_facts(contact_facts(contact), values);
  elements::fill_table(models_table(), "TABLE", values);
  for (const figures::experiments::ModelExperiment& experiment : experiments) {
    engine::TemplateValues& entry = values.add_section("CONTENTS_ENTRY");
    entry.set("SECTION_ID", experiment.id);
    entry.set("TITLE", experiment.title);
    engine::TemplateValues& section = values.add_section("EXPERIMENT");
    section.set("SECTION_ID", experiment.id);
    section.set("TITLE", experiment.title);
    section.set("EXPLANATION", experiment.explanation);
    for (const elements::FigureCard& card : elements::figure_cards(experiment.figures, drawn)) {
      elements::fill_figure(card, section);
    }
  }
  return engine::expand_template("models.tpl", values, language);
}

}  // namespace tribolog::report::experiments
