#pragma once
// Internal to the verdict: the effects of the one model (method/model/) that the recordings show
// beyond doubt. They are taken off the model's quantities; what the model does not read, such as
// loops and ramps, still contains them.

#include <optional>
#include <string_view>
#include <vector>

#include "verdict/rules.h"

namespace tribolog::verdict {

/// The catalogue's row; null: it has none, as of "choice_of_law".
const joint::Effect* row_of_effect(std::string_view key);

/// @param key of an effect, or "choice_of_law".
Statement name_of_effect(std::string_view key);

/// One statement for each effect that is, with its size, the largest first.
std::vector<Statement> effect_findings(const calibration::Calibration& calibration);

/// Its largest torque in percent of `whole_Nm`, with the statement of it; zero where the effect is
/// not beyond doubt.
/// @param effect its key in the catalogue.
/// @return nothing where there is no model, or none of the effect in it.
std::optional<Measured> measure_effect(const calibration::Calibration& calibration,
                                       std::string_view effect, double whole_Nm);

}  // namespace tribolog::verdict
