#pragma once
// Every figure of every example, by example.

#include <string>
#include <string_view>
#include <vector>

#include "figures/report_figure.h"
#include "wording/language.h"

namespace tribolog::test {

/// A name safe for a test: "paper", "noise", "ripple", "sweep_alone", "plan", "models", "study",
/// "history".
std::vector<std::string> swept_examples();

/// The figures of one of them, described in a language; computed once in a process.
/// @throw std::invalid_argument for another name
const std::vector<figures::ReportFigure>& figures_of(std::string_view example,
                                                     const wording::Language& language = {});

}  // namespace tribolog::test
