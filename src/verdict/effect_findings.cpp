#include "verdict/effect_findings.h"

#include <algorithm>
#include <string>

namespace tribolog::verdict {
namespace {

using method::model::ModelEffect;
using method::model::ModelResult;

Statement statement_of(const ModelEffect& effect, const ModelResult& model) {
  return {"model.effect_shows",
          {{"effect", name_of_effect(effect.key)},
           {"largest_Nm", effect.largest_Nm.value},
           {"half_width_Nm", effect.largest_Nm.half_width()},
           {"percent", 100 * effect.largest_Nm.value / model.friction_Nm}}};
}

/// Recordings unlike the others that the model did without. Points stand behind the recordings.
Statement recordings_left_out(const calibration::Calibration& c) {
  std::vector<Statement> names;
  for (const int at : c.model.left_out) {
    const auto k = static_cast<std::size_t>(at);
    if (k < c.curves.log.size()) names.push_back(Statement::verbatim(c.curves.log[k].recording));
  }
  return {"model.recordings_left_out",
          {{"recordings", c.model.left_out.size()}, {"names", std::move(names)}}};
}

}  // namespace

const joint::Effect* row_of_effect(std::string_view key) {
  const std::vector<joint::Effect>& all = joint::effects();
  const auto row = std::find_if(all.begin(), all.end(),
                                [&](const joint::Effect& effect) { return effect.key == key; });
  return row == all.end() ? nullptr : &*row;
}

Statement name_of_effect(std::string_view key) {
  return Statement(Code::of("effect." + std::string(key)));
}

std::vector<Statement> effect_findings(const calibration::Calibration& c) {
  std::vector<const ModelEffect*> found;
  for (const ModelEffect& effect : c.model.effects) {
    if (effect.is_plain()) found.push_back(&effect);
  }
  std::stable_sort(found.begin(), found.end(), [](const ModelEffect* a, const ModelEffect* b) {
    return a->largest_Nm.value > b->largest_Nm.value;
  });
  std::vector<Statement> all;
  all.reserve(found.size());
  for (const ModelEffect* effect : found) all.push_back(statement_of(*effect, c.model));
  if (!c.model.left_out.empty()) all.push_back(recordings_left_out(c));
  return all;
}

std::optional<Measured> measure_effect(const calibration::Calibration& c, std::string_view effect,
                                       double whole_Nm) {
  const ModelEffect* found = c.model.find(effect);
  if (found == nullptr || !(whole_Nm > 0)) return std::nullopt;
  return Measured{found->is_plain() ? 100 * found->largest_Nm.value / whole_Nm : 0.0,
                  statement_of(*found, c.model)};
}

}  // namespace tribolog::verdict
