#pragma once
// A comparison in words: for the console and for the page, the same ones.

#include <string>
#include <vector>

#include "history/comparison.h"
#include "report/report_view.h"

namespace tribolog::report {

/// "1 of 8 comparable quantities changed; 2 are not comparable."
std::string comparison_sentence(const history::Comparison& comparison);

/// A row for each quantity: first, second, change, in percent, word.
Table compared_quantities_table(const history::Comparison& comparison);

/// Temperature, payload and so on of both.
Table compared_conditions_table(const history::Comparison& comparison);

/// "Coulomb torque is not comparable: ...", cautions, remarks; each a sentence. What is said of
/// several quantities stands once.
std::vector<std::string> comparison_notes(const history::Comparison& comparison);

}  // namespace tribolog::report
