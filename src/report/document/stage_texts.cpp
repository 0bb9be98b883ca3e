// Names and standing texts of the stages.

#include "base/enum_text.h"
#include "report/document/view_parts.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::report::document {

namespace {
using wording::tr;
}

const statistics::StageReport& stage_report(const calibration::Calibration& c, StageId stage) {
  switch (stage) {
    case StageId::cog_rough:
      return c.rough.stage;
    case StageId::cog_precise:
      return c.precise.stage;
    case StageId::hysteresis:
      return c.hysteresis.stage;
    case StageId::surrogate_masses:
      return c.masses.stage;
    case StageId::viscous_curves:
      return c.viscous.stage;
    case StageId::quality_errors:
      return c.quality.stage;
    case StageId::selection:
      return c.selection.stage;
    case StageId::break_away:
      return c.break_away.stage;
    case StageId::parameters:
      break;
  }
  return c.friction.stage;
}

int stage_number(StageId stage) { return static_cast<int>(stage) + 1; }

std::string section_anchor(StageId stage) { return "stage-" + std::to_string(stage_number(stage)); }

std::string stage_title(StageId stage) { return wording::words_for("stage", own_name(stage)); }

std::string explanation_template(StageId stage) { return "explain_" + own_name(stage) + ".tpl"; }

std::string helpful_experiment(StageId stage) {
  return wording::words_for("helpful_experiment", own_name(stage));
}

std::string stage_reference(StageId stage) {
  return tr("stage {stage}", {{"stage", stage_number(stage)}});
}

std::string status_in_words(statistics::StageState state) {
  return wording::words_for("stage_state", to_string(state));
}

}  // namespace tribolog::report::document
