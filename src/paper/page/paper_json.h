#pragma once
// Internal to the report: the checks of the paper for machines.

#include <string>

#include "paper/page/paper_page.h"

namespace tribolog::report {

/// {"schema": "tribolog-paper-1", "tool", "items": [{kind, number, section, title, checks: [{what,
/// origin, expected, ours, difference, allowed, unit, holds}]}], "golden_numbers": [...]}.
/// A number that is not finite is null; words stand where words are compared.
std::string paper_json(const RegeneratedPaper& paper);

}  // namespace tribolog::report
